// Places in the panel: who mirrors whose sides.
#include "experiment/store/sqlite_panel.h"

#include <charconv>
#include <map>

namespace experiment::store {

namespace {

using protocols::ObserverId;

int place_in(const SqliteDatabase& database, const std::string& text) {
    int place = -1;
    const auto* last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), last, place);
    if (error != std::errc() || end != last || place < 0)
        throw database.complaint("holds the place \"" + text +
                                 "\" of an observer, expected a whole number; verify the store");
    return place;
}

std::map<int, ObserverId> places(const SqliteDatabase& database, ObserverKind kind) {
    std::map<int, ObserverId> taken;
    for (const auto& row :
         database.query("SELECT answer, observer FROM answers WHERE question = ? ORDER BY seq",
                        {place_question(kind)}))
        taken[place_in(database, text_of(row[0]))] = {text_of(row[1])};
    return taken;
}

int free_among(const std::map<int, ObserverId>& taken) {
    int place = 0;
    while (taken.contains(place))
        ++place;
    return place;
}

std::optional<ObserverId> one_before(const std::map<int, ObserverId>& taken, int place) {
    const auto before = taken.find(place - 1);
    return place % 2 == 1 && before != taken.end() ? std::optional(before->second) : std::nullopt;
}

} // namespace

std::string place_question(ObserverKind kind) {
    return kind == ObserverKind::Person ? "place in the panel" : "place among the simulated";
}

int free_place(const SqliteDatabase& database, ObserverKind kind) {
    return free_among(places(database, kind));
}

bool is_without_place(const SqliteDatabase& database, const ObserverId& observer) {
    return database
        .query("SELECT 1 FROM answers WHERE observer = ? AND question IN (?, ?) UNION ALL SELECT 1 "
               "FROM sittings WHERE observer = ?",
               {observer.value, place_question(ObserverKind::Person),
                place_question(ObserverKind::Simulated), observer.value})
        .empty();
}

std::optional<ObserverId>
partner_in(const SqliteDatabase& database, const ObserverId& observer, ObserverKind kind) {
    if (is_without_place(database, observer)) {
        const auto taken = places(database, kind);
        return one_before(taken, free_among(taken));
    }
    for (const auto each : {ObserverKind::Person, ObserverKind::Simulated}) {
        const auto taken = places(database, each);
        for (const auto& [place, who] : taken)
            if (who == observer)
                return one_before(taken, place);
    }
    return std::nullopt;
}

} // namespace experiment::store
