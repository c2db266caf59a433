/// Texts that users write: what is read, and what is refused with its place.

#include "weavefront/scene/text.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "example.hpp"

namespace weavefront::scene::test {
namespace {

std::string fault(const std::string& text) {
    try {
        require_text(text, "t");
    } catch (const InputError& error) {
        return error.messages().front();
    }
    return {};
}

TEST(Text, WhatIsNotUtf8IsRefusedWithItsLineColumnAndByte) {
    EXPECT_EQ(fault("a\nSto\xDF auf"), "t:2:4: found the byte 0xDF ('ß' in Latin-1), allowed text in UTF-8");
    EXPECT_EQ(
        fault("Zw\xC3\xB6lf \xFC"),
        "t:1:7: found the byte 0xFC ('ü' in Latin-1), allowed text in UTF-8");  // columns are characters
    EXPECT_EQ(fault("\x80"), "t:1:1: found the byte 0x80, allowed text in UTF-8");
    EXPECT_EQ(fault("\xE2\x82"),
              "t:1:1: found the byte 0xE2 ('â' in Latin-1), allowed text in UTF-8");  // cut short
    EXPECT_EQ(fault("\xC0\xAF"),
              "t:1:1: found the byte 0xC0 ('À' in Latin-1), allowed text in UTF-8");  // longer than need be
    EXPECT_EQ(
        fault("\xED\xA0\x80"),
        "t:1:1: found the byte 0xED ('í' in Latin-1), allowed text in UTF-8");  // half of a surrogate pair
    EXPECT_EQ(fault("\xF4\x90\x80\x80"),
              "t:1:1: found the byte 0xF4 ('ô' in Latin-1), allowed text in UTF-8");  // beyond Unicode
    EXPECT_EQ(fault("Zwölf Lagen, 30° – 漢字 😀\t\r\n"), "");
}

TEST(Text, ControlCharactersAndUtf16AreRefused) {
    EXPECT_EQ(fault(std::string("ab\0c", 4)), "t:1:3: found a NUL byte, allowed text in UTF-8");
    EXPECT_EQ(fault("\x1b[31m"), "t:1:1: found the control character 0x1B, allowed text in UTF-8");
    EXPECT_EQ(fault(std::string("\xff\xfe"
                                "a\0",
                                4)),
              "t:1:1: found text in UTF-16, allowed text in UTF-8");
}

TEST(Text, MessagesShowWhatCannotBeSeenAndShortenWhatIsLong) {
    EXPECT_EQ(printable("1440\u00a0kg \xDF\t"), "1440<U+00A0>kg <0xDF><U+0009>");
    EXPECT_EQ(printable("zwölf"), "zwölf");
    EXPECT_EQ(printable(std::string(5'000'000, 'x'), 3), "xxx... (5000000 bytes)");
}

TEST(Text, NumbersAreDecimalAndFinite) {
    EXPECT_EQ(finite_number("+1.5e3"), 1500);
    EXPECT_EQ(finite_number(" -2\u00a0"), -2);
    for (const char* text : {"", " ", "0x10", "1,5", "1 2", "nan", "inf", "1e999", "++1", "1e"})
        EXPECT_FALSE(finite_number(text)) << text;
}

class Files : public testing::Test {
  protected:
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("weavefront_scene_text_" + std::to_string(::getpid()));
    ~Files() override { std::filesystem::remove(path); }

    std::string refusal(std::size_t most = most_of_document) {
        try {
            read_text(path, most);
        } catch (const std::runtime_error& error) {
            return std::string(error.what()).substr(path.string().size());
        }
        return "read";
    }
};

TEST_F(Files, AByteOrderMarkIsNoPartOfTheText) {
    std::ofstream(path) << "\xEF\xBB\xBFtime,F11\n";
    EXPECT_EQ(read_text(path), "time,F11\n");
}

TEST_F(Files, AreReadUpToABound) {
    std::ofstream(path) << "12345";
    EXPECT_EQ(read_text(path, 5), "12345");
    EXPECT_EQ(refusal(4), ": found a file of more than 4 bytes, allowed at most 4");
}

TEST_F(Files, HaveAnEnd) {
    std::filesystem::create_symlink("/dev/zero", path);
    EXPECT_EQ(refusal(), ": cannot be read: it is a pipe, a socket or a device, allowed is a regular file");
    std::filesystem::remove(path);
    ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
    EXPECT_EQ(refusal(), ": cannot be read: it is a pipe, a socket or a device, allowed is a regular file");
}

TEST_F(Files, OnesThatCannotBeReadSayWhy) {
    EXPECT_EQ(refusal(), ": cannot be read: No such file or directory");
    std::filesystem::create_symlink(path, path);
    EXPECT_EQ(refusal(), ": cannot be read: Too many levels of symbolic links");
}

TEST(TextOfOverrides, IsUtf8) {
    EXPECT_EQ(findings(example, {"title=Sto\xDF"}),
              std::vector<std::string>{
                  "--set title=Sto<0xDF>: found the byte 0xDF ('ß' in Latin-1), allowed text in UTF-8"});
}

// As copied from a PDF or a web page.
TEST(Quantities, AnySpaceOfUnicodeMayStandBetweenNumberAndUnit) {
    for (const std::string space : {"\u00a0", "\u2009", "\u202f", "\u2007", "\u3000"}) {
        EXPECT_EQ(parse(example_with("1440 kg/m^3", "1440" + space + "kg/m^3")).fabrics[0].density, 1440)
            << space;
        EXPECT_EQ(
            parse(example_with("35 MPa s", "35" + space + "MPa" + space + "s")).fabrics[0].elastic.viscosity,
            35e6)
            << space;
        EXPECT_EQ(parse(example_with("3.3 %", "3.3" + space + "%")).fabrics[0].failure->static_strain, 0.033)
            << space;
    }
}

}  // namespace
}  // namespace weavefront::scene::test
