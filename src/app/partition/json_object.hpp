#pragma once
/// @file
/// A JSON object whose keys know where they stand and may be there twice, which the library's own does not
/// tell.

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace weavefront::app {

/// A key of the object and its value. Of an object or a list only the kind is kept.
struct JsonMember {
    std::string key, where;  ///< `file:line:column` of the key
    nlohmann::json value;
};

/// Reads one JSON object. @param name of the file, for messages @throws scene::InputError when it is not
/// JSON, or JSON of another kind
std::vector<JsonMember> parse_json_object(const std::string& text, const std::string& name);

}  // namespace weavefront::app
