#include "weavefront/scene/compare.hpp"

#include <yaml-cpp/yaml.h>

#include <map>
#include <set>

namespace weavefront::scene {

namespace {

using Leaves = std::map<std::string, std::string>;

void collect(const YAML::Node& node, const std::string& path, Leaves& leaves) {
    if (node.IsMap())
        for (const auto& entry : node)
            collect(entry.second, path + (path.empty() ? "" : ".") + entry.first.as<std::string>(), leaves);
    else if (node.IsSequence())
        for (std::size_t i = 0; i < node.size(); ++i)
            collect(node[i], path + "." + std::to_string(i), leaves);
    else
        leaves.emplace(path, node.IsNull() ? "" : node.as<std::string>());
}

Leaves leaves_of(const std::string& resolved) {
    Leaves leaves;
    collect(YAML::Load(resolved), "", leaves);
    return leaves;
}

}  // namespace

std::vector<Difference> differences(const std::string& first, const std::string& second) {
    const auto of_first = leaves_of(first), of_second = leaves_of(second);
    std::set<std::string> paths;
    for (const auto* leaves : {&of_first, &of_second})
        for (const auto& [path, value] : *leaves) paths.insert(path);
    const auto value_of = [](const Leaves& leaves, const std::string& path) {
        const auto found = leaves.find(path);
        return found == leaves.end() ? std::string() : found->second;
    };
    std::vector<Difference> result;
    for (const auto& path : paths) {
        Difference difference{path, value_of(of_first, path), value_of(of_second, path)};
        if (difference.first != difference.second) result.push_back(std::move(difference));
    }
    return result;
}

}  // namespace weavefront::scene
