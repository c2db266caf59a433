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
    Frame layout;  ///< fixes the arrays of all frames: names, components, kinds; its values are not read
    std::int64_t max_frames;  ///< frames to make room for; more room is made where it does not last
    std::string scene;        ///< the resolved scene
    std::string version;      ///< of Weavefront
};

/// The results file, in global order whatever the rank count. It can be read while the run writes it and
/// after the run was killed at any moment: its structure is settled before it takes its name, frames only
/// fill space that is there, and the number of frames is raised when a frame is complete. A file with more
/// room, or less, takes the place of the one before as a whole.
class Results {
  public:
    /// Creates the file under its temporary name.
    /// @param setup  what is constant
    /// @param comm   ranks of the run; must outlive this object
    /// @throws FileError on all ranks when the disk cannot hold the file, or it cannot be created or written;
    /// std::logic_error when the ids of the topology are no partition
    /// @note Collective
    Results(const ResultsSetup& setup, const parallel::Communicator& comm);
    /// Goes on with the file that is there, after its first frames. It stays as it is until `publish`.
    /// @throws FileError on all ranks when it holds fewer frames, or is that of another scene
    /// @note Collective
    Results(const ResultsSetup& setup, std::int64_t frames, const parallel::Communicator& comm);
    ~Results();
    Results(Results&&) noexcept;
    Results& operator=(Results&&) noexcept;

    /// Gives the file its name, in place of one that exists, or cuts it to the frames after which it goes on.
    /// @throws FileError on all ranks @note Collective
    void publish();

    /// Appends a frame to the published file; on return it is on disk and readable.
    /// @param frame  state of the owned nodes and elements; arrays as in ResultsSetup::layout
    /// @throws NotFinite, FileError on all ranks, also when the file was moved or removed; std::logic_error
    /// when the arrays are not those of the layout
    /// @note Collective
    void write(const Frame& frame);

    /// Gives room back that no frame has filled. @return false where the disk cannot hold the shorter file
    /// beside the longer one, which stays
    /// @note Collective
    bool cut();

    /// Waits until all frames are on the disk. @throws FileError on all ranks @note Collective
    void sync();

    /// From now on frames come from ranks that own other nodes and elements. @note Collective
    void redistribute(const Topology& topology);

    /// Frames written so far.
    [[nodiscard]] std::int64_t frames() const;
    /// What the file takes with these, bytes.
    [[nodiscard]] double bytes() const;

  private:
    class File;
    std::unique_ptr<File> file_;
};

}  // namespace weavefront::io
