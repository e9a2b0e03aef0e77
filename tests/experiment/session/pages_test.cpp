#include "experiment/session/pages.h"

namespace {

using namespace experiment::session;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Pages, AreSeparatedByLinesOfDashes) {
    EXPECT_THAT(split_pages("# One\ntext - with -- dashes\n---\nTwo\n\n----- \r\n  \nThree"),
                ElementsAre("# One\ntext - with -- dashes", "Two", "Three"));
}

TEST(Pages, ThatAreEmptyAreNone) {
    EXPECT_THAT(split_pages("---\n\n---\n  only  \n---\n"), ElementsAre("only"));
    EXPECT_THAT(split_pages(""), IsEmpty());
    EXPECT_THAT(split_pages("\n \n---\n"), IsEmpty());
}

TEST(Pages, KeepOtherAlphabets) {
    EXPECT_THAT(split_pages("Grüße\n---\n質問"), ElementsAre("Grüße", "質問"));
}

TEST(Pages, FlowWithinParagraphsAsMarkdownDoes) {
    EXPECT_EQ(instruction_page(
                  {}, "# Head\nOne **bold**\nword.\n\n> asked\n\n- first\n  goes on\n- second")
                  .text,
              "# Head\nOne bold word.\n\nasked\n\n- first goes on\n- second");
}

TEST(Pages, SayTheQuestionBeforeThePairs) {
    const auto page = question_page({}, "Which looks more like wax?", true);
    EXPECT_THAT(page.text, HasSubstr("Which looks more like wax?"));
    EXPECT_EQ(page.advance, Key::Release);
}

} // namespace
