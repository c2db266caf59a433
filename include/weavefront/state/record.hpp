#pragma once
/// @file
/// Archives that carry the state of one item between ranks as plain numbers.
///
/// An archive is called with the name and the value of each piece of state, always in the same order. `size`
/// announces how many times the pieces of the names that follow repeat; `within` groups names. `reads` tells
/// whether the archive writes the values or reads them.

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace weavefront::state {

/// Appends values to a record; the names do not travel.
class RecordWriter {
  public:
    static constexpr bool reads = false;
    explicit RecordWriter(std::vector<double>& record) : record_(&record) {}

    void operator()(std::string_view, double& value) { record_->push_back(value); }
    std::size_t size(std::string_view, std::size_t count) {
        record_->push_back(static_cast<double>(count));
        return count;
    }
    template <class Visit>
    void within(std::string_view, Visit visit) {
        visit();
    }

  private:
    std::vector<double>* record_;
};

/// Takes values from the front of what RecordWriter has written.
class RecordReader {
  public:
    static constexpr bool reads = true;
    explicit RecordReader(std::span<const double> record) : record_(record) {}

    void operator()(std::string_view, double& value) { value = next(); }
    std::size_t size(std::string_view, std::size_t) { return static_cast<std::size_t>(next()); }
    template <class Visit>
    void within(std::string_view, Visit visit) {
        visit();
    }

    /// What has not been taken yet.
    [[nodiscard]] std::span<const double> rest() const { return record_; }

  private:
    double next() {
        const double value = record_.front();
        record_ = record_.subspan(1);
        return value;
    }
    std::span<const double> record_;
};

}  // namespace weavefront::state
