#include "experiment/store/row_chain.h"

namespace {

using namespace experiment::store;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<ChainedRow> chain_of(int length) {
    std::vector<ChainedRow> rows;
    std::string predecessor;
    for (std::int64_t seq = 1; seq <= length; ++seq) {
        ChainedRow row{"votes", seq, {seq * 10, std::string("left"), Value()}, {}};
        row.digest = predecessor = row_digest(predecessor, row);
        rows.push_back(row);
    }
    return rows;
}

std::vector<std::string> findings(const std::vector<ChainedRow>& rows, const std::string& head) {
    return chain_findings(rows, 5, head);
}

TEST(RowChain, OfUntouchedRowsHasNoFindings) {
    const auto rows = chain_of(5);
    EXPECT_THAT(findings(rows, rows.back().digest), IsEmpty());
}

TEST(RowChain, FindsTheOneRowThatWasChanged) {
    auto rows = chain_of(5);
    rows[2].values[1] = std::string("right");
    EXPECT_THAT(findings(rows, rows.back().digest),
                ElementsAre(HasSubstr("row 3 (votes 30 right) was changed")));
}

TEST(RowChain, FindsAChangedRowEvenWhenItsDigestWasMadeAnew) {
    auto rows = chain_of(5);
    rows[2].values[1] = std::string("right");
    rows[2].digest = row_digest(rows[1].digest, rows[2]);
    EXPECT_THAT(findings(rows, rows.back().digest), ElementsAre(HasSubstr("row 4 (")));
}

TEST(RowChain, FindsRowsThatAreMissing) {
    auto rows = chain_of(5);
    const auto head = rows.back().digest;
    rows.erase(rows.begin() + 1);
    EXPECT_THAT(findings(rows, head), ElementsAre("row 2 is missing"));
    rows.erase(rows.begin() + 1);
    EXPECT_THAT(findings(rows, head), ElementsAre("rows 2 to 3 are missing"));
}

TEST(RowChain, FindsRowsThatWereCutOffAtTheEnd) {
    auto rows = chain_of(5);
    const auto head = rows.back().digest;
    rows.resize(3);
    EXPECT_THAT(findings(rows, head), ElementsAre("2 row(s) are missing at the end"));
}

TEST(RowChain, FindsRowsThatChangedPlaces) {
    auto rows = chain_of(5);
    std::swap(rows[1].values, rows[2].values);
    EXPECT_THAT(findings(rows, rows.back().digest),
                ElementsAre(HasSubstr("row 2 ("), HasSubstr("row 3 (")));
    rows = chain_of(5);
    std::swap(rows[1].values, rows[2].values);
    std::swap(rows[1].digest, rows[2].digest);
    EXPECT_THAT(findings(rows, rows.back().digest),
                ElementsAre(HasSubstr("row 2 ("), HasSubstr("row 3 ("), HasSubstr("row 4 (")));
}

TEST(RowChain, TellsATextFromANumberAndFieldsFromEachOther) {
    const auto digest = [](Row values) { return row_digest("", {"votes", 1, values, {}}); };
    EXPECT_NE(digest({std::int64_t{1}}), digest({std::string("1")}));
    EXPECT_NE(digest({std::string("ab"), std::string("c")}),
              digest({std::string("a"), std::string("bc")}));
    EXPECT_NE(digest({Value()}), digest({std::string()}));
}

} // namespace
