/// Archives read what they have written, and refuse what does not fit.

#include <gtest/gtest.h>

#include <span>

#include "weavefront/state/record.hpp"
#include "weavefront/state/table.hpp"
#include "weavefront/state/values.hpp"

namespace weavefront::state {
namespace {

/// An item with a number of its own and a list, as an element with its contact points.
struct Item {
    double a = 0;
    std::vector<double> list;

    template <class Archive>
    void state(Archive& archive) {
        archive("a", a);
        archive.within("list", [&] {
            list.resize(archive.size("entry", list.size()));
            for (auto& entry : list) archive("entry", entry);
        });
    }
};

std::vector<Item> items() { return {{1, {}}, {2, {0.5, -0.25}}, {3, {}}, {4, {7}}}; }

void expect_same(const std::vector<Item>& read) {
    const auto expected = items();
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(read[i].a, expected[i].a);
        EXPECT_EQ(read[i].list, expected[i].list);
    }
}

TEST(Record, GivesBackItemAfterItem) {
    std::vector<double> record;
    RecordWriter writer(record);
    for (auto& item : items()) {
        auto copy = item;
        copy.state(writer);
    }
    std::vector<Item> read(4);
    RecordReader reader(record);
    for (auto& item : read) item.state(reader);
    expect_same(read);
    EXPECT_TRUE(reader.rest().empty());
}

Table written() {
    Table table{{10, 20, 30, 40}, {}};
    ColumnWriter writer(table);
    auto all = items();
    for (std::size_t i = 0; i < all.size(); ++i) {
        writer.start(i);
        all[i].state(writer);
    }
    return table;
}

TEST(Table, HoldsOneColumnAName) {
    const auto table = written();
    ASSERT_EQ(table.columns.size(), 2U);
    EXPECT_EQ(table.columns[0].name, "a");
    EXPECT_EQ(table.columns[1].name, "list.entry");
    EXPECT_EQ(table.columns[1].counts, (std::vector<std::int32_t>{0, 2, 0, 1}));
    EXPECT_EQ(table.columns[1].values, (std::vector<double>{0.5, -0.25, 7}));
}

TEST(Table, GivesBackItemAfterItem) {
    auto table = written();
    ColumnReader reader(table);
    std::vector<Item> read(4);
    for (std::size_t i = 0; i < read.size(); ++i) {
        reader.start(i);
        read[i].state(reader);
    }
    reader.finish();
    expect_same(read);
}

TEST(Table, RefusesAMissingColumnByName) {
    auto table = written();
    table.columns.erase(table.columns.begin());
    ColumnReader reader(table);
    Item item;
    reader.start(0);
    try {
        item.state(reader);
        FAIL();
    } catch (const Mismatch& mismatch) {
        EXPECT_STREQ(mismatch.what(), "it holds no a of item 10");
    }
}

TEST(Table, RefusesValuesThatNobodyKnowsByName) {
    auto table = written();
    table.columns.push_back({"b", {1, 1, 1, 1}, {0, 0, 0, 0}});
    ColumnReader reader(table);
    Item item;
    reader.start(0);
    item.state(reader);
    try {
        reader.start(1);
        FAIL();
    } catch (const Mismatch& mismatch) {
        EXPECT_STREQ(mismatch.what(), "it holds b of item 10, which this program does not know");
    }
}

TEST(Values, OfRanksAreBroughtTogether) {
    const parallel::Communicator comm(MPI_COMM_WORLD);
    std::int64_t part = comm.rank() + 1;
    std::vector<double> least{static_cast<double>(comm.rank()), static_cast<double>(-comm.rank())};
    Values values;
    ValueWriter writer(values, comm);
    writer.sum("part", part);
    writer.least("least", least);
    std::int64_t read = -1;
    std::vector<double> read_least(2);
    ValueReader reader(values, comm);
    reader.sum("part", read);
    reader.least("least", read_least);
    EXPECT_EQ(read, comm.rank() == 0 ? comm.size() * (comm.size() + 1) / 2 : 0);
    EXPECT_EQ(read_least, (std::vector<double>{0, static_cast<double>(1 - comm.size())}));
}

TEST(Values, AreReadByNameAndKind) {
    const auto comm = parallel::Communicator::alone();
    double number = 0.1;
    std::int64_t integer = std::int64_t{1} << 60;
    bool flag = true;
    std::string text = "text";
    std::optional<double> none, some = 3;
    Values values;
    ValueWriter writer(values, comm);
    writer("number", number), writer("integer", integer), writer("flag", flag), writer("text", text);
    writer("none", none), writer("some", some);
    double read_number = 0;
    std::int64_t read_integer = 0;
    bool read_flag = false;
    std::string read_text;
    std::optional<double> read_none = 1, read_some;
    ValueReader reader(values, comm);
    reader("some", read_some), reader("none", read_none), reader("text", read_text);
    reader("flag", read_flag), reader("integer", read_integer), reader("number", read_number);
    EXPECT_EQ(read_number, number);
    EXPECT_EQ(read_integer, integer);
    EXPECT_TRUE(read_flag);
    EXPECT_EQ(read_text, text);
    EXPECT_FALSE(read_none);
    EXPECT_EQ(read_some, some);
    EXPECT_THROW(reader("some", std::span<double>()), Mismatch);  // one value is written
    EXPECT_THROW(reader("missing", read_number), Mismatch);
    EXPECT_THROW(reader("integer", read_number), Mismatch);
}

}  // namespace
}  // namespace weavefront::state
