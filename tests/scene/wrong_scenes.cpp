/// Every kind of refusal: wrong_scenes.yaml holds the scenes and the exact words.

#include <gtest/gtest.h>
#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <ostream>

#include "example.hpp"

namespace weavefront::scene::test {
namespace {

struct WrongScene {
    std::string name;
    std::string bytes;  ///< of the file
    std::vector<std::string> overrides;
    Need need;
    std::vector<std::string> says;
};

void PrintTo(const WrongScene& scene, std::ostream* stream) { *stream << scene.name; }

std::string in_latin1(const std::string& text) {
    std::string bytes;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        if (byte < 0x80)
            bytes += text[i];
        else
            bytes += static_cast<char>((byte & 0x03U) << 6 | (static_cast<unsigned char>(text[++i]) & 0x3FU));
    }
    return bytes;
}

std::string in_utf16(const std::string& ascii) {
    std::string bytes = "\xff\xfe";
    for (const char c : ascii) bytes.append({c, '\0'});
    return bytes;
}

std::string bytes_of(const YAML::Node& row) {
    std::string text = row["text"] ? row["text"].as<std::string>() : example;
    for (const auto& change : row["change"])
        text = with(text, change.first.as<std::string>(), change.second.as<std::string>());
    text += row["append"].as<std::string>("");
    text.append(row["bytes"].as<std::size_t>(text.size()) - text.size(), ' ');
    const auto encoding = row["encoding"].as<std::string>("utf-8");
    return encoding == "latin-1" ? in_latin1(text) : encoding == "utf-16" ? in_utf16(text) : text;
}

std::vector<std::string> texts_of(const YAML::Node& node) {
    if (!node) return {};
    return node.IsScalar() ? std::vector{node.as<std::string>()} : node.as<std::vector<std::string>>();
}

std::vector<WrongScene> wrong_scenes() {
    std::vector<WrongScene> scenes;
    for (const auto& group : YAML::LoadFile(WEAVEFRONT_SCENE_TESTS "/wrong_scenes.yaml"))
        for (const auto& row : group.second)
            scenes.push_back(
                {row["wrong"].as<std::string>(), bytes_of(row), texts_of(row["set"]),
                 row["need"].as<std::string>("impact") == "impact" ? Need::impact : Need::fabrics,
                 texts_of(row["says"])});
    return scenes;
}

class WrongScenes : public testing::TestWithParam<WrongScene> {
  protected:
    WrongScenes() {
        std::filesystem::create_directory(folder_);
        std::filesystem::current_path(folder_);
    }
    ~WrongScenes() override {
        std::filesystem::current_path(before_);
        std::filesystem::remove_all(folder_);
    }

  private:
    const std::filesystem::path before_ = std::filesystem::current_path();
    const std::filesystem::path folder_ =
        std::filesystem::temp_directory_path() / ("weavefront_wrong_scenes_" + std::to_string(::getpid()));
};

TEST_P(WrongScenes, AreRefusedInTheseWords) {
    std::ofstream("s.yaml", std::ios::binary) << GetParam().bytes;
    std::vector<std::string> said;
    try {
        read_scene("s.yaml", GetParam().overrides, GetParam().need);
    } catch (const InputError& error) {
        said = error.shown();
    }
    EXPECT_EQ(said, GetParam().says);
}

INSTANTIATE_TEST_SUITE_P(Table, WrongScenes, testing::ValuesIn(wrong_scenes()), [](const auto& row) {
    std::string name = row.param.name;
    for (char& c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    return name;
});

}  // namespace
}  // namespace weavefront::scene::test
