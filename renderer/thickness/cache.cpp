// One header that says how to read on, one sequence of plain values under a checksum.
#include "renderer/thickness/cache.h"

#include "renderer/contract.h"
#include "renderer/harmonics/basis.h"
#include "renderer/thickness/checksum.h"
#include "renderer/thickness/streams.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace renderer::thickness {

namespace fs = std::filesystem;

namespace {

using Bytes = std::vector<std::byte>;

constexpr std::array<char, 8> magic{'P', 'L', 't', 'h', 'i', 'c', 'k', '\n'};
constexpr std::uint32_t byte_order = 0x01020304; // another machine's reads 0x04030201
// Grows with every change of this format and of what tracing computes.
constexpr std::uint32_t version = 2;
constexpr std::uint32_t fibonacci_scheme = 0;

struct Header {
    std::array<char, 8> magic;
    std::uint32_t byte_order;
    std::uint32_t version;
    std::uint64_t file_size;
    std::uint64_t checksum; ///< of everything behind the header
};

static_assert(sizeof(Header) == 32 && std::is_trivially_copyable_v<Header>); // no padding

template <class T>
concept Plain = std::is_arithmetic_v<T>;

class Writer {
  public:
    template <Plain T>
    void put(T value) {
        put(std::span<const T>(&value, 1));
    }

    template <Plain T>
    void put(std::span<const T> values) {
        const auto bytes = std::as_bytes(values);
        bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
    }

    void put(glm::dvec3 v) {
        put(v.x);
        put(v.y);
        put(v.z);
    }

    Bytes take() { return std::move(bytes_); }

  private:
    Bytes bytes_;
};

/// Reads what Writer wrote; past the end it reads zeros and says so in `is_good`.
class Reader {
  public:
    explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}

    template <Plain T>
    T get() {
        T value{};
        get(std::span<T>(&value, 1));
        return value;
    }

    template <Plain T>
    void get(std::span<T> values) {
        if (values.size_bytes() > bytes_.size()) {
            is_good_ = false;
            return;
        }
        if (!values.empty())
            std::memcpy(values.data(), bytes_.data(), values.size_bytes());
        bytes_ = bytes_.subspan(values.size_bytes());
    }

    glm::dvec3 get_vector() {
        const double x = get<double>(), y = get<double>(), z = get<double>();
        return {x, y, z};
    }

    /// Whether so many elements of a size can follow: asked before memory is taken for them.
    bool has(std::uint64_t count, std::size_t size) {
        is_good_ = is_good_ && count <= bytes_.size() / size;
        return is_good_;
    }

    bool is_good() const { return is_good_; }

    bool is_at_end() const { return bytes_.empty(); }

  private:
    std::span<const std::byte> bytes_;
    bool is_good_ = true;
};

void put_options(Writer& out, const FieldOptions& options) {
    out.put(static_cast<std::uint32_t>(options.kind));
    out.put(fibonacci_scheme);
    out.put(static_cast<std::uint32_t>(options.directions));
    out.put(static_cast<std::uint32_t>(options.bands));
    out.put(options.rotation_seed);
}

/// nullopt for a kind or a scheme that this program does not know.
std::optional<FieldOptions> get_options(Reader& in) {
    const auto kind = in.get<std::uint32_t>(), scheme = in.get<std::uint32_t>();
    FieldOptions options;
    options.kind = static_cast<Kind>(kind);
    options.directions = static_cast<int>(in.get<std::uint32_t>());
    options.bands = static_cast<int>(in.get<std::uint32_t>());
    options.rotation_seed = in.get<std::uint64_t>();
    const bool is_known = kind <= static_cast<std::uint32_t>(Kind::Span) &&
                          scheme == fibonacci_scheme && options.bands >= 1 && options.bands <= 6;
    return is_known ? std::optional(options) : std::nullopt;
}

void put_summary(Writer& out, const ThicknessField& field) {
    out.put(field.d_n);
    out.put(static_cast<std::uint32_t>(field.percentiles.size()));
    for (const auto& [fraction, length] : field.percentiles) {
        out.put(fraction);
        out.put(length);
    }
    out.put(field.bounds.centre);
    out.put(field.bounds.radius);
    out.put(field.statistics.rays);
    out.put(field.statistics.retried);
    out.put(field.statistics.fallbacks);
    out.put(field.statistics.past_openings);
}

void get_summary(Reader& in, ThicknessField& field) {
    field.d_n = in.get<double>();
    const auto percentiles = in.get<std::uint32_t>();
    if (!in.has(percentiles, 2 * sizeof(double)))
        return;
    for (std::uint32_t i = 0; i < percentiles; ++i) {
        const double fraction = in.get<double>(), length = in.get<double>();
        field.percentiles.push_back({fraction, length});
    }
    field.bounds.centre = in.get_vector();
    field.bounds.radius = in.get<double>();
    field.statistics.rays = in.get<std::uint64_t>();
    field.statistics.retried = in.get<std::uint64_t>();
    field.statistics.fallbacks = in.get<std::uint64_t>();
    field.statistics.past_openings = in.get<std::uint64_t>();
}

void put_bins(Writer& out, const NormalBins& bins) {
    out.put(static_cast<std::uint32_t>(bins.bands));
    out.put(static_cast<std::uint32_t>(bins.bins.size()));
    for (const auto& bin : bins.bins) {
        out.put(bin.share);
        out.put(bin.normal);
        out.put(std::span<const double>(bin.moments));
    }
}

void get_bins(Reader& in, NormalBins& bins) {
    const auto bands = in.get<std::uint32_t>(), count = in.get<std::uint32_t>();
    const std::size_t n = std::size_t{bands} * bands, moments = n * (n + 1) / 2;
    if (bands > 6 || !in.has(count, sizeof(double) * (4 + moments)))
        return;
    bins.bands = static_cast<int>(bands);
    for (std::uint32_t i = 0; i < count; ++i) {
        NormalBin bin;
        bin.share = in.get<double>();
        bin.normal = in.get_vector();
        bin.moments.resize(moments);
        in.get(std::span(bin.moments));
        bins.bins.push_back(std::move(bin));
    }
}

void put_streams(Writer& out, const ThicknessField& field) {
    const auto streams = band_streams(field, field.bands, ComponentType::Float32);
    out.put(static_cast<std::uint32_t>(ComponentType::Float32));
    out.put(static_cast<std::uint32_t>(streams.size()));
    for (const auto& stream : streams) {
        out.put(static_cast<std::uint32_t>(stream.first_band));
        out.put(static_cast<std::uint32_t>(stream.last_band));
        out.put(std::span<const float>(stream.scale));
        out.put(std::span(reinterpret_cast<const unsigned char*>(stream.bytes.data()),
                          stream.bytes.size()));
    }
}

void get_streams(Reader& in, std::uint64_t vertices, ThicknessField& field) {
    const auto type = static_cast<ComponentType>(in.get<std::uint32_t>());
    const auto count = in.get<std::uint32_t>();
    if (type > ComponentType::Float16 || !in.has(count, 1))
        return;
    std::vector<Stream> streams;
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto first = in.get<std::uint32_t>(), last = in.get<std::uint32_t>();
        if (last > 5 || first > last)
            return;
        Stream stream{type, static_cast<int>(first), static_cast<int>(last), {}, {}, {}};
        stream.scale.resize((last + 1) * (last + 1) - first * first);
        in.get(std::span(stream.scale));
        const std::size_t bytes_per_vertex = stream.scale.size() * bytes_of(type);
        if (!in.has(vertices, bytes_per_vertex))
            return;
        stream.bytes.resize(vertices * bytes_per_vertex);
        in.get(
            std::span(reinterpret_cast<unsigned char*>(stream.bytes.data()), stream.bytes.size()));
        streams.push_back(std::move(stream));
    }
    if (!streams.empty() && streams.back().last_band + 1 == field.bands)
        field.coefficients = coefficients_of(streams);
}

Bytes payload_of(std::uint64_t mesh, const ThicknessField& field) {
    Writer out;
    out.put(mesh);
    out.put(static_cast<std::uint64_t>(field.energy.size()));
    put_options(out, field.options);
    put_summary(out, field);
    put_bins(out, field.normal_bins);
    out.put(std::span<const double>(field.energy));
    put_streams(out, field);
    return out.take();
}

std::string refusal(const fs::path& file, std::string_view reason) {
    return fmt::format("{}: {}", file.string(), reason);
}

Expected<std::optional<ThicknessField>> field_in(std::span<const std::byte> payload,
                                                 const fs::path& file,
                                                 std::uint64_t mesh,
                                                 const FieldOptions& wanted) {
    Reader in(payload);
    const auto mesh_there = in.get<std::uint64_t>(), vertices = in.get<std::uint64_t>();
    const auto options = get_options(in);
    if (mesh_there != mesh || !options || !serves(*options, wanted))
        return std::nullopt;
    ThicknessField field;
    field.bands = options->bands;
    field.options = *options;
    get_summary(in, field);
    get_bins(in, field.normal_bins);
    if (in.has(vertices, sizeof(double))) {
        field.energy.resize(vertices);
        in.get(std::span(field.energy));
        get_streams(in, vertices, field);
    }
    const auto n = static_cast<std::size_t>(harmonics::coefficient_count(field.bands));
    if (!in.is_good() || !in.is_at_end() || field.coefficients.size() != n * vertices)
        return tl::unexpected(refusal(file, "is damaged: its parts do not fit together"));
    return field;
}

/// The whole file; nullopt when there is none.
Expected<std::optional<Bytes>> bytes_in(const fs::path& file) {
    std::error_code failure;
    if (!fs::exists(file, failure))
        return std::nullopt;
    const auto size = fs::file_size(file, failure);
    if (failure)
        return tl::unexpected(refusal(file, "cannot be read: " + failure.message()));
    Bytes bytes(size);
    std::ifstream stream(file, std::ios::binary);
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    if (!stream)
        return tl::unexpected(refusal(file, "cannot be read to its end"));
    return bytes;
}

/// Writes all and flushes it to the disk; false with errno set.
bool write_all(int descriptor, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0)
            return false;
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return ::fsync(descriptor) == 0;
}

} // namespace

std::uint64_t mesh_hash(const geometry::Mesh& mesh) {
    static_assert(sizeof(glm::dvec3) == 3 * sizeof(double)); // no padding
    const std::array<std::uint64_t, 2> counts{mesh.positions.size(), mesh.triangles.size()};
    const auto positions = checksum(std::as_bytes(std::span(mesh.positions)),
                                    checksum(std::as_bytes(std::span(counts))));
    return checksum(std::as_bytes(std::span(mesh.triangles)), positions);
}

Expected<std::optional<ThicknessField>>
read_field(const fs::path& file, std::uint64_t mesh, const FieldOptions& options) {
    const auto bytes = bytes_in(file);
    if (!bytes)
        return tl::unexpected(bytes.error());
    if (!*bytes)
        return std::nullopt;
    Header header{};
    if ((*bytes)->size() < sizeof header)
        return tl::unexpected(refusal(file, "is damaged: it ends inside its header"));
    std::memcpy(&header, (*bytes)->data(), sizeof header);
    if (header.magic != magic)
        return tl::unexpected(refusal(file, "is not a thickness field"));
    if (header.byte_order != byte_order || header.version != version)
        return std::nullopt;
    const auto payload = std::span<const std::byte>(**bytes).subspan(sizeof header);
    if (header.file_size != (*bytes)->size())
        return tl::unexpected(refusal(file, fmt::format("is damaged: it has {} bytes, expected {}",
                                                        (*bytes)->size(), header.file_size)));
    if (header.checksum != checksum(payload))
        return tl::unexpected(refusal(file, "is damaged: its checksum is wrong"));
    return field_in(payload, file, mesh, options);
}

Expected<void> write_field(const fs::path& file, std::uint64_t mesh, const ThicknessField& field) {
    EXPECTS(field.options.bands == field.bands);
    const Bytes payload = payload_of(mesh, field);
    const Header header{magic, byte_order, version, sizeof(Header) + payload.size(),
                        checksum(payload)};

    std::string beside =
        (file.parent_path() / ("." + file.filename().string() + ".XXXXXX")).string();
    const int descriptor = ::mkstemp(beside.data());
    if (descriptor < 0)
        return tl::unexpected(
            refusal(file, fmt::format("cannot be written: {}", std::strerror(errno))));
    // mkstemp keeps others out; a cache is for everyone who may read the folder.
    bool is_written = ::fchmod(descriptor, 0644) == 0 &&
                      write_all(descriptor, std::as_bytes(std::span(&header, 1))) &&
                      write_all(descriptor, payload);
    is_written = ::close(descriptor) == 0 && is_written;
    is_written = is_written && std::rename(beside.c_str(), file.c_str()) == 0;
    if (is_written)
        return {};
    const std::string reason = std::strerror(errno);
    ::unlink(beside.c_str());
    return tl::unexpected(refusal(file, "cannot be written: " + reason));
}

} // namespace renderer::thickness
