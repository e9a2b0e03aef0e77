// The built-in pages' words.  A key in braces {} is filled in from the study's key map.
#include "experiment/session/words.h"

#include <algorithm>
#include <array>

namespace experiment::session {

namespace {

constexpr Words english{
    .language = "en",
    .next_page = "{}: next page",
    .questions_heading = "Any questions?",
    .questions_ask = "Please ask them now.",
    .questions_task = "In every pair that follows: {}",
    .questions_adapt = "First the screen stays grey for a while, so that your eyes get used to it. "
                       "Then the pairs begin.",
    .answer_left = "{}, or a click on the left picture: the left one.",
    .answer_right = "{}, or a click on the right picture: the right one.",
    .answer_first = "{}: the first picture.",
    .answer_second = "{}: the second picture.",
    .answer_not_sure = "{}: not sure.",
    .flip = "{}: the other picture.",
    .grades_of_right = "Compared with the left picture, the right one is",
    .grades_of_second = "Compared with the first picture, the second one is",
    .grades = {"much worse", "worse", "slightly worse", "the same", "slightly better", "better",
               "much better"},
    .questions_keys = "{} (the experimenter): begin",
    .training_again_key = "{}: practise again",
    .break_heading = "Time for a break",
    .break_text = "Rest your eyes for a minute or more. Go on when you feel like it.",
    .break_keys = "{}: go on (after ten seconds)",
    .paused_heading = "Paused",
    .paused_left = "The window was left. The last pair will be shown again.",
    .paused_changed = "The screen has changed. The last pair will be shown again.",
    .paused_keys = "{} (the experimenter): go on",
    .stop_heading = "Do you want to stop here?",
    .stop_text = "Your answers so far are kept. The session can be taken up again later, with the "
                 "pair that was on the screen.",
    .stop_keys = "{}: go on      {}: stop",
    .limit_heading = "That is long enough",
    .limit_text =
        "This session has reached the longest time that the study allows. Please call the "
        "experimenter. Your answers are kept.",
    .limit_keys = "{} (the experimenter): go on all the same      {}: stop for today",
    .thanks_heading = "Thank you!",
    .thanks_text = "This session is finished and all your answers are stored.",
    .thanks_keys = "{}: close",
    .display_heading = "The screen, for the experimenter",
    .display_keys = "{} (the experimenter): as it should be",
    .contrast_heading = "Brightness and contrast",
    .contrast_text = "In the dark field, the bar on the right should just be seen and the one on "
                     "the left should not. In the bright field, all three steps should be seen.",
    .contrast_keys = "{} (the experimenter): it is so",
    .patch_keys = "{}: next patch"};

constexpr Words german{
    .language = "de",
    .next_page = "{}: nächste Seite",
    .questions_heading = "Haben Sie Fragen?",
    .questions_ask = "Bitte stellen Sie sie jetzt.",
    .questions_task = "Bei jedem der folgenden Paare: {}",
    .questions_adapt = "Zuerst bleibt der Bildschirm eine Weile grau, damit sich Ihre Augen daran "
                       "gewöhnen. Dann beginnen die Paare.",
    .answer_left = "{} oder ein Klick auf das linke Bild: das linke.",
    .answer_right = "{} oder ein Klick auf das rechte Bild: das rechte.",
    .answer_first = "{}: das erste Bild.",
    .answer_second = "{}: das zweite Bild.",
    .answer_not_sure = "{}: nicht sicher.",
    .flip = "{}: das andere Bild.",
    .grades_of_right = "Verglichen mit dem linken Bild ist das rechte",
    .grades_of_second = "Verglichen mit dem ersten Bild ist das zweite",
    .grades = {"viel schlechter", "schlechter", "etwas schlechter", "gleich", "etwas besser",
               "besser", "viel besser"},
    .questions_keys = "{} (Versuchsleitung): beginnen",
    .training_again_key = "{}: noch einmal üben",
    .break_heading = "Zeit für eine Pause",
    .break_text = "Ruhen Sie Ihre Augen eine Minute oder länger aus. Machen Sie weiter, wenn Sie "
                  "möchten.",
    .break_keys = "{}: weiter (nach zehn Sekunden)",
    .paused_heading = "Unterbrochen",
    .paused_left = "Das Fenster wurde verlassen. Das letzte Paar wird noch einmal gezeigt.",
    .paused_changed = "Der Bildschirm hat sich geändert. Das letzte Paar wird noch einmal gezeigt.",
    .paused_keys = "{} (Versuchsleitung): weiter",
    .stop_heading = "Möchten Sie hier aufhören?",
    .stop_text =
        "Ihre bisherigen Antworten bleiben erhalten. Die Sitzung kann später mit dem Paar, "
        "das gerade zu sehen war, fortgesetzt werden.",
    .stop_keys = "{}: weiter      {}: aufhören",
    .limit_heading = "Das ist lang genug",
    .limit_text =
        "Diese Sitzung hat die längste Dauer erreicht, die die Studie erlaubt. Bitte rufen "
        "Sie die Versuchsleitung. Ihre Antworten bleiben erhalten.",
    .limit_keys = "{} (Versuchsleitung): trotzdem weiter      {}: für heute aufhören",
    .thanks_heading = "Vielen Dank!",
    .thanks_text = "Diese Sitzung ist beendet, und alle Ihre Antworten sind gespeichert.",
    .thanks_keys = "{}: schließen",
    .display_heading = "Der Bildschirm, für die Versuchsleitung",
    .display_keys = "{} (Versuchsleitung): wie es sein soll",
    .contrast_heading = "Helligkeit und Kontrast",
    .contrast_text =
        "Im dunklen Feld soll der rechte Balken gerade noch zu sehen sein und der linke "
        "nicht. Im hellen Feld sollen alle drei Stufen zu sehen sein.",
    .contrast_keys = "{} (Versuchsleitung): so ist es",
    .patch_keys = "{}: nächstes Feld"};

constexpr std::array all{&english, &german};

const Words* found(std::string_view language) {
    const auto stem = language.substr(0, language.find('-'));
    const auto* const place = std::find_if(
        all.begin(), all.end(), [&](const Words* words) { return words->language == stem; });
    return place == all.end() ? nullptr : *place;
}

struct KeyNames {
    std::string_view name, english, german;
};

constexpr std::array key_words{KeyNames{"Left", "Left arrow", "Pfeil links"},
                               KeyNames{"Right", "Right arrow", "Pfeil rechts"},
                               KeyNames{"Up", "Up arrow", "Pfeil hoch"},
                               KeyNames{"Down", "Down arrow", "Pfeil runter"},
                               KeyNames{"Space", "Space", "Leertaste"},
                               KeyNames{"Enter", "Enter", "Eingabe"},
                               KeyNames{"Delete", "Delete", "Entf"},
                               KeyNames{"Backspace", "Backspace", "Rücktaste"},
                               KeyNames{"Insert", "Insert", "Einfg"},
                               KeyNames{"Home", "Home", "Pos1"},
                               KeyNames{"End", "End", "Ende"},
                               KeyNames{"PageUp", "Page up", "Bild auf"},
                               KeyNames{"PageDown", "Page down", "Bild ab"}};

} // namespace

const Words& words_in(std::string_view language) {
    const auto* words = found(language);
    return words != nullptr ? *words : english;
}

std::string spoken_key(std::string_view name, const Words& words) {
    for (const auto& key : key_words)
        if (key.name == name)
            return std::string(&words == &german ? key.german : key.english);
    return std::string(name);
}

bool speaks(std::string_view language) {
    return found(language) != nullptr;
}

std::vector<std::string> spoken_languages() {
    std::vector<std::string> languages;
    for (const auto* words : all)
        languages.emplace_back(words->language);
    return languages;
}

} // namespace experiment::session
