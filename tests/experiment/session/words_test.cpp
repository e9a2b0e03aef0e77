#include "experiment/session/pages.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace experiment::session;
using testing::HasSubstr;

std::vector<PageView> all_pages(const PageStyle& style) {
    return {instruction_page(style, "text"),
            question_page(style, "which?", true),
            break_page(style),
            paused_page(style, PauseReason::WindowLeft),
            paused_page(style, PauseReason::ScreenChanged),
            stop_page(style),
            limit_page(style),
            thanks_page(style),
            display_page(style, "a=1; b=2"),
            contrast_page(style),
            photometer_page(style, 1, 2, 3)};
}

TEST(Words, AreThereForEveryPageInEveryLanguage) {
    ASSERT_GE(spoken_languages().size(), 2u);
    for (const auto& language : spoken_languages()) {
        PageStyle style;
        style.words = &words_in(language);
        for (const auto response :
             {protocols::Response::ForcedChoice, protocols::Response::WithNotSure,
              protocols::Response::SevenGrades}) {
            style.response = response;
            for (const auto& page : all_pages(style)) {
                EXPECT_FALSE(page.text.empty()) << language;
                EXPECT_FALSE(page.keys.empty()) << language;
                EXPECT_EQ(page.text.find("{}"), std::string::npos) << page.text;
                EXPECT_EQ(page.keys.find("{}"), std::string::npos) << page.keys;
            }
        }
    }
}

TEST(Words, DifferBetweenLanguages) {
    PageStyle english, german;
    german.words = &words_in("de-AT");
    const auto one = all_pages(english);
    const auto other = all_pages(german);
    for (std::size_t i = 0; i < one.size(); ++i)
        EXPECT_NE(one[i].keys, other[i].keys);
    EXPECT_EQ(&words_in("ja"), &words_in("en"));
    EXPECT_FALSE(speaks("ja"));
}

TEST(Pages, NameTheKeysOfTheStudy) {
    PageStyle style;
    style.keys[protocols::Action::Left] = {"A"};
    style.keys[protocols::Action::Forward] = {"KP_Add"};
    EXPECT_THAT(question_page(style, "which?", false).text, HasSubstr("A, or a click"));
    EXPECT_THAT(break_page(style).keys, HasSubstr("KP_Add"));
    EXPECT_THAT(question_page(style, "which?", true).keys, HasSubstr("F8"));
    EXPECT_THAT(question_page(style, "which?", false).keys, testing::Not(HasSubstr("F8")));
}

TEST(Pages, SayWhatEachGradeMeans) {
    PageStyle style;
    style.response = protocols::Response::SevenGrades;
    const auto text = question_page(style, "which?", true).text;
    EXPECT_THAT(text, HasSubstr("the right one is\n- 1: much worse\n- 2: worse"));
    EXPECT_THAT(text, HasSubstr("- 7: much better"));
}

} // namespace
