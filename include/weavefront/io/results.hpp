#pragma once
/// @file
/// results.vtkhdf: the pictures of a run, as VTKHDF 2.0 (unstructured grid, time series).

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "weavefront/io/rows.hpp"
#include "weavefront/parallel/communicator.hpp"

namespace weavefront::io {

/// What a results file is told once. Everything but the topology is the same on all ranks.
struct ResultsSetup {
    std::filesystem::path path;
    Topology topology;
    Surface surface;
    Frame layout;             ///< fixes the arrays of all frames: names, components, kinds; its values are not read
    std::int64_t max_frames;  ///< frames there is room for
    std::string scene;        ///< the resolved scene
    std::string version;      ///< of Weavefront
};

/// The results file, in global order whatever the rank count. It can be read while the run writes it and after the run was killed at any
/// moment: its structure is settled before it takes its name, frames only fill space that is there, and the number of frames is raised when
/// a frame is complete.
class Results {
  public:
    /// Creates the file, replacing one that exists.
    /// @param setup  what is constant
    /// @param comm   ranks of the run; must outlive this object
    /// @throws FileError on all ranks when the file cannot be created or written; std::logic_error when the ids of the topology are no
    /// partition
    /// @note Collective
    Results(const ResultsSetup& setup, const parallel::Communicator& comm);
    ~Results();
    Results(Results&&) noexcept;
    Results& operator=(Results&&) noexcept;

    /// Appends a frame; on return it is on disk and readable.
    /// @param frame  state of the owned nodes and elements; arrays as in ResultsSetup::layout
    /// @throws NotFinite, FileError on all ranks; std::logic_error when the arrays are not those of the layout or the file is full
    /// @note Collective
    void write(const Frame& frame);

    /// From now on frames come from ranks that own other nodes and elements. @note Collective
    void redistribute(const Topology& topology);

    /// Frames written so far.
    [[nodiscard]] std::int64_t frames() const;

  private:
    class File;
    std::unique_ptr<File> file_;
};

}  // namespace weavefront::io
