#include "strip_frames.hpp"

#include <cmath>
#include <map>

#include "weavefront/io/read_results.hpp"

namespace weavefront::app {

namespace {

/// Initial places that differ by rounding only are one, m.
std::int64_t place(double x) { return std::llround(x * 1e10); }

struct Columns {
    std::map<std::int64_t, std::size_t> index;  // place of the column to its number
    std::vector<std::int64_t> of_element;

    Columns(const std::vector<std::array<double, 3>>& points,
            const std::vector<std::array<std::int64_t, 4>>& quads) {
        for (const auto& quad : quads) {
            double x = 0;
            for (const std::int64_t node : quad) x += points[static_cast<std::size_t>(node)][0] / 4;
            of_element.push_back(place(x));
            index.emplace(place(x), 0);
        }
        std::size_t next = 0;
        for (auto& column : index) column.second = next++;
    }
};

}  // namespace

std::vector<study::StripFrame> strip_frames(const std::filesystem::path& results) {
    const io::ResultsReader reader(results);
    const auto start = reader.points(0);
    const Columns columns(start, reader.quads());
    std::map<std::int64_t, std::size_t> line;  // initial x to node
    for (std::size_t node = 0; node < start.size(); ++node)
        if (place(start[node][1]) == 0) line.emplace(place(start[node][0]), node);

    std::vector<study::StripFrame> frames;
    for (std::size_t k = 0; k < reader.times().size(); ++k) {
        study::StripFrame frame{.time = reader.times()[k], .x = {}, .z = {}, .centre = {}, .strain = {}};
        const auto points = reader.points(k);
        for (const auto& [x, node] : line) {
            frame.x.push_back(points[node][0]);
            frame.z.push_back(points[node][2]);
        }
        const auto strain = reader.cells("strain_fill", k);
        std::vector<double> count(columns.index.size(), 0.0);
        frame.strain.assign(columns.index.size(), 0.0);
        for (std::size_t e = 0; e < strain.size(); ++e) {
            const std::size_t column = columns.index.at(columns.of_element[e]);
            frame.strain[column] += strain[e];
            count[column] += 1;
        }
        for (std::size_t i = 0; i < count.size(); ++i) frame.strain[i] /= count[i];
        for (const auto& [x, column] : columns.index) frame.centre.push_back(static_cast<double>(x) * 1e-10);
        frames.push_back(std::move(frame));
    }
    return frames;
}

}  // namespace weavefront::app
