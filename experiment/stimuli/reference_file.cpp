// The film's channels, and its counts as lines of text beside them.
#include "experiment/stimuli/reference_file.h"

#include "renderer/imaging/image_files.h"
#include "renderer/reference/film_layers.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <vector>

namespace experiment::stimuli {

namespace imaging = renderer::imaging;
namespace reference = renderer::reference;

namespace {

using Texts = std::vector<imaging::TextEntry>;

const std::string* find(const Texts& texts, std::string_view name) {
    for (const auto& entry : texts)
        if (entry.name == name)
            return &entry.text;
    return nullptr;
}

template <class Number>
bool read_number(const Texts& texts, std::string_view name, Number& number) {
    const auto* text = find(texts, name);
    if (text == nullptr)
        return false;
    const char* end = text->data() + text->size();
    const auto [stopped, error] = std::from_chars(text->data(), end, number);
    return error == std::errc() && stopped == end;
}

} // namespace

tl::expected<void, std::string> write_reference(const std::filesystem::path& file,
                                                const StoredReference& stored) {
    const auto& film = stored.film;
    return imaging::write_layers(file, reference::layers_of(film),
                                 {{"reference:recipe", stored.recipe},
                                  {"reference:seed", fmt::format("{}", film.seed)},
                                  {"reference:log2_batch", fmt::format("{}", film.log2_batch)},
                                  {"reference:batches", fmt::format("{}", film.batches)},
                                  {"reference:paths", fmt::format("{}", film.paths)},
                                  {"reference:leaks", fmt::format("{}", film.leaks)},
                                  {"Software", PAIRLIGHT_PROGRAM_VERSION}});
}

tl::expected<StoredReference, std::string> read_reference(const std::filesystem::path& file) {
    const auto texts = imaging::read_texts(file);
    if (!texts)
        return tl::unexpected(texts.error());
    reference::FilmRecord record;
    const auto* recipe = find(*texts, "reference:recipe");
    const bool is_complete = recipe != nullptr &&
                             read_number(*texts, "reference:seed", record.seed) &&
                             read_number(*texts, "reference:log2_batch", record.log2_batch) &&
                             read_number(*texts, "reference:batches", record.batches) &&
                             read_number(*texts, "reference:paths", record.paths) &&
                             read_number(*texts, "reference:leaks", record.leaks);
    if (!is_complete || record.log2_batch < 0 || record.log2_batch > 16 || record.batches < 2)
        return tl::unexpected(
            fmt::format("{}: is not a reference that `pairlight reference` wrote", file.string()));
    const auto layers = imaging::read_layers(file);
    if (!layers)
        return tl::unexpected(layers.error());
    auto film = reference::film_of(*layers, record);
    if (!film)
        return tl::unexpected(fmt::format("{}: {}", file.string(), film.error()));
    return StoredReference{std::move(*film), *recipe};
}

} // namespace experiment::stimuli
