#include "weavefront/io/new_file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>

#include <csignal>

#include "scratch_directory.hpp"
#include "weavefront/io/file_error.hpp"
#include "weavefront/io/replace_file.hpp"

namespace weavefront::io {
namespace {

class NewFileTest : public testing::Test {
  protected:
    const parallel::Communicator comm_{MPI_COMM_WORLD};
    const ScratchDirectory directory_{comm_};
    const std::filesystem::path path_ = directory_ / "table.csv", temporary_ = directory_ / "table.csv.new";

    void put(const std::filesystem::path& path, const std::string& text) const {
        std::ofstream(path) << text;
    }
    [[nodiscard]] std::string refusal() const {
        return message_of<FileError>([&] { replace_file(path_, "text"); });
    }
};

TEST_F(NewFileTest, TakesTheNameOfTheOldOneAsAWhole) {
    put(path_, "old");
    NewFile file(path_);
    file.append("new ");
    file.append("text");
    EXPECT_EQ(content(path_), "old");
    EXPECT_EQ(content(temporary_), "new text");
    file.publish();
    EXPECT_EQ(content(path_), "new text");
    EXPECT_FALSE(std::filesystem::exists(temporary_));
}

TEST_F(NewFileTest, LeavesNothingUnlessItIsPublished) {
    put(path_, "old");
    { const NewFile file(path_); }
    EXPECT_EQ(content(path_), "old");
    EXPECT_FALSE(std::filesystem::exists(temporary_));
}

// Somebody may have put it there for the next program to write through.
TEST_F(NewFileTest, NeverTouchesALink) {
    put(directory_ / "target", "precious");
    std::filesystem::create_symlink(directory_ / "target", path_);
    EXPECT_EQ(refusal(),
              path_.string() + " cannot be written: it is a link, allowed is a regular file or none");
    std::filesystem::remove(path_);
    std::filesystem::create_symlink(directory_ / "target", temporary_);
    EXPECT_NE(refusal().find(temporary_.string() + " is in the way"), std::string::npos) << refusal();
    EXPECT_TRUE(std::filesystem::is_symlink(temporary_));
    EXPECT_EQ(content(directory_ / "target"), "precious");
    NewFile file(directory_ / "other.csv");
    std::filesystem::create_symlink(directory_ / "target", directory_ / "other.csv");  // while it is written
    EXPECT_THROW(file.publish(), FileError);
    EXPECT_EQ(content(directory_ / "target"), "precious");
}

TEST_F(NewFileTest, NeverReplacesWhatIsNoFile) {
    ASSERT_EQ(::mkfifo(path_.c_str(), 0600), 0);
    EXPECT_EQ(refusal(),
              path_.string() + " cannot be written: it is a FIFO, allowed is a regular file or none");
    std::filesystem::remove(path_);
    std::filesystem::create_directory(path_);
    EXPECT_EQ(refusal(),
              path_.string() + " cannot be written: it is a folder, allowed is a regular file or none");
    std::filesystem::remove(path_);
    // One of the system's would be lost if this failed.
    if (::mknod(path_.c_str(), S_IFCHR | 0600, makedev(1, 3)) != 0) GTEST_SKIP() << "only root makes devices";
    EXPECT_EQ(refusal(),
              path_.string() + " cannot be written: it is a device, allowed is a regular file or none");
    EXPECT_TRUE(std::filesystem::is_character_file(path_));
}

TEST_F(NewFileTest, NeverReplacesTheTemporaryFileOfAnother) {
    put(temporary_, "of another program");
    EXPECT_NE(refusal().find(temporary_.string() + " is in the way"), std::string::npos) << refusal();
    EXPECT_EQ(content(temporary_), "of another program");
}

TEST_F(NewFileTest, HoldsWholeTextsWhenTheDiskIsFull) {
    rlimit before{};
    ::getrlimit(RLIMIT_FSIZE, &before);
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{10, before.rlim_max};
    NewFile file(path_);
    ::setrlimit(RLIMIT_FSIZE, &limit);
    file.append("12345\n");
    EXPECT_EQ(message_of<FileError>([&] { file.append("67890\n"); }),
              path_.string() + " cannot be written: File too large");
    ::setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_EQ(content(temporary_), "12345\n");
}

}  // namespace
}  // namespace weavefront::io
