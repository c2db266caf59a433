#pragma once
/// @file
/// results.vtkhdf read back.

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace weavefront::io {

/// The fabric of a results file over its frames; one process reads.
class ResultsReader {
  public:
    /// @throws FileError when the file cannot be read
    explicit ResultsReader(const std::filesystem::path& path);
    ~ResultsReader();
    ResultsReader(const ResultsReader&) = delete;
    ResultsReader& operator=(const ResultsReader&) = delete;

    /// Times of the frames, s.
    [[nodiscard]] const std::vector<double>& times() const;
    /// Positions of the nodes, m.
    [[nodiscard]] std::vector<std::array<double, 3>> points(std::size_t frame) const;
    /// The nodes of each element.
    [[nodiscard]] std::vector<std::array<std::int64_t, 4>> quads() const;
    /// A cell array of one component, one value an element. @throws FileError when the run has not written it
    [[nodiscard]] std::vector<double> cells(const std::string& name, std::size_t frame) const;

  private:
    class File;
    std::unique_ptr<File> file_;
};

/// Whether a file can be read as results; one that was cut cannot.
bool is_results_file(const std::filesystem::path& path);

}  // namespace weavefront::io
