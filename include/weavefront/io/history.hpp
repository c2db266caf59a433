#pragma once
/// @file
/// history.csv: the run as a table, one row per output time.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "weavefront/io/new_file.hpp"
#include "weavefront/io/rows.hpp"
#include "weavefront/io/sha256.hpp"
#include "weavefront/parallel/communicator.hpp"

namespace weavefront::io {

/// The column names of history.csv, separated by commas.
/// @param layout a row with the parts that all rows have
std::string history_header(const HistoryRow& layout = {});

/// One row as text, 17 significant digits, without the end of the line.
/// @throws NotFinite naming the column
std::string history_line(const HistoryRow& row);

/// How much of a table there is, and its SHA-256.
struct Written {
    std::int64_t bytes = 0;
    std::string sha256;
};

/// The growing table. Rank 0 writes whole lines, each handed to the system before `write` returns, so a run
/// killed at any moment leaves complete rows.
class History {
  public:
    /// Starts the file with its header, under its temporary name.
    /// @param path   of the file
    /// @param layout a row with the parts that all rows have
    /// @param comm   ranks of the run; must outlive this object
    /// @throws FileError on all ranks
    /// @note Collective
    History(const std::filesystem::path& path, const HistoryRow& layout, const parallel::Communicator& comm);
    /// Goes on with a table that is there, after its first bytes. What is beyond them stays until `publish`.
    /// @param written what the table held when its run was left
    /// @throws FileError on all ranks when its first bytes are others, or fewer
    /// @note Collective
    History(const std::filesystem::path& path, const Written& written, const parallel::Communicator& comm);
    ~History();
    History(History&&) noexcept;
    History& operator=(History&&) noexcept;

    /// What was written so far, on the disk; on rank 0. @throws FileError on all ranks @note Collective
    [[nodiscard]] Written written() const;

    /// Gives the file its name, in place of one that exists, or cuts it where it goes on. @throws FileError
    /// on all ranks @note Collective
    void publish();

    /// Appends a row.
    /// @param row  read on rank 0
    /// @throws NotFinite, FileError on all ranks; nothing of a row that is not finite is written
    /// @note Collective
    void write(const HistoryRow& row);

    /// @throws FileError on all ranks when the published file was moved or removed @note Collective
    void require_in_place() const;

    /// SHA-256 of the header and the rows, 64 hex digits; on rank 0.
    [[nodiscard]] std::string hash() const;

  private:
    void append(std::string line);

    std::unique_ptr<NewFile> file_;  // on rank 0
    Sha256 sha256_;
    std::int64_t bytes_ = 0;
    const parallel::Communicator* comm_;
};

}  // namespace weavefront::io
