#include "weavefront/io/read_results.hpp"

#include "hdf5_handle.hpp"
#include "hdf5_reader.hpp"
#include "weavefront/io/file_error.hpp"

namespace weavefront::io {

class ResultsReader::File {
  public:
    explicit File(const std::filesystem::path& path) : path_(path.string()) {
        const QuietHdf5 quiet;
        file_ = open_to_read(path_, path_ + ": opening");
        nodes_ = static_cast<hsize_t>(numbers<std::int64_t>("NumberOfPoints", 0, 1)[0]);
        elements_ = static_cast<hsize_t>(numbers<std::int64_t>("NumberOfCells", 0, 1)[0]);
        times_ = numbers<double>("Steps/Values", 0, frames());
    }

    [[nodiscard]] hsize_t nodes() const { return nodes_; }
    [[nodiscard]] hsize_t elements() const { return elements_; }
    [[nodiscard]] const std::vector<double>& times() const { return times_; }

    /// Rows `first`, ... of an array below /VTKHDF, all its columns.
    template <class T>
    [[nodiscard]] std::vector<T> numbers(const std::string& name, hsize_t first, hsize_t rows) const {
        const QuietHdf5 quiet;
        const std::string doing = path_ + ": reading " + name;
        const H5Dataset data(checked(H5Dopen2(file_.get(), ("/VTKHDF/" + name).c_str(), H5P_DEFAULT), doing));
        return read_rows<T>(data, static_cast<std::int64_t>(first), static_cast<std::int64_t>(rows), doing);
    }

    [[nodiscard]] hsize_t offset(const std::string& name, std::size_t frame) const {
        return static_cast<hsize_t>(numbers<std::int64_t>("Steps/" + name, frame, 1)[0]);
    }

  private:
    [[nodiscard]] hsize_t frames() const {
        const std::string doing = path_ + ": reading NSteps";
        const H5Group steps(checked(H5Gopen2(file_.get(), "/VTKHDF/Steps", H5P_DEFAULT), doing));
        const H5Attribute attribute(checked(H5Aopen(steps.get(), "NSteps", H5P_DEFAULT), doing));
        return static_cast<hsize_t>(number_in(attribute, doing));
    }

    std::string path_;
    H5File file_;
    hsize_t nodes_ = 0, elements_ = 0;
    std::vector<double> times_;
};

ResultsReader::ResultsReader(const std::filesystem::path& path) : file_(std::make_unique<File>(path)) {}

ResultsReader::~ResultsReader() = default;

bool is_results_file(const std::filesystem::path& path) {
    try {
        const ResultsReader reader(path);
        return true;
    } catch (const FileError&) {
        return false;
    }
}

const std::vector<double>& ResultsReader::times() const { return file_->times(); }

std::vector<std::array<double, 3>> ResultsReader::points(std::size_t frame) const {
    const auto flat = file_->numbers<double>("Points", file_->offset("PointOffsets", frame), file_->nodes());
    std::vector<std::array<double, 3>> points(flat.size() / 3);
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i] = {flat[3 * i], flat[3 * i + 1], flat[3 * i + 2]};
    return points;
}

std::vector<std::array<std::int64_t, 4>> ResultsReader::quads() const {
    const auto flat = file_->numbers<std::int64_t>("Connectivity", 0, 4 * file_->elements());
    std::vector<std::array<std::int64_t, 4>> quads(flat.size() / 4);
    for (std::size_t i = 0; i < quads.size(); ++i)
        quads[i] = {flat[4 * i], flat[4 * i + 1], flat[4 * i + 2], flat[4 * i + 3]};
    return quads;
}

std::vector<double> ResultsReader::cells(const std::string& name, std::size_t frame) const {
    return file_->numbers<double>("CellData/" + name, file_->offset("CellDataOffsets/" + name, frame),
                                  file_->elements());
}

}  // namespace weavefront::io
