// Rays as CSV.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "renderer/geometry/input_error.h"
#include "renderer/io/file.h"
#include "renderer/io/printable.h"
#include "renderer/io/tables.h"

namespace kd {

namespace {

struct Column {
    std::string_view name;
    bool required;
    float& (*field)(Ray& ray);
};

constexpr std::array<Column, 8> columns{{
    {"ox", true, [](Ray& ray) -> float& { return ray.origin.x; }},
    {"oy", true, [](Ray& ray) -> float& { return ray.origin.y; }},
    {"oz", true, [](Ray& ray) -> float& { return ray.origin.z; }},
    {"dx", true, [](Ray& ray) -> float& { return ray.direction.x; }},
    {"dy", true, [](Ray& ray) -> float& { return ray.direction.y; }},
    {"dz", true, [](Ray& ray) -> float& { return ray.direction.z; }},
    {"tmin", false, [](Ray& ray) -> float& { return ray.t_min; }},
    {"tmax", false, [](Ray& ray) -> float& { return ray.t_max; }},
}};

constexpr std::string_view header_help = "the first line must be ox,oy,oz,dx,dy,dz with tmin,tmax where wanted";

/// Where in the file the reader is; throws errors that say so.
struct Place {
    std::string file;
    std::size_t line = 0;

    [[noreturn]] void fail(const std::string& reason) const {
        throw InputError(printable(file, 4096) + ":" + std::to_string(line) + ": " + reason);
    }
};

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blank = " \t\r";
    const std::size_t begin = text.find_first_not_of(blank);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(blank) - begin + 1);
}

/// At most one cell more than `most`, so that a line of nothing but commas costs no memory.
std::vector<std::string_view> cells_of(std::string_view line, std::size_t most) {
    std::vector<std::string_view> cells;
    while (true) {
        const std::size_t comma = line.find(',');
        cells.push_back(trimmed(line.substr(0, comma)));
        if (comma == std::string_view::npos || cells.size() > most) return cells;
        line.remove_prefix(comma + 1);
    }
}

/// The float nearest to digits that from_chars calls out of range: 0 or denormal where too small, else infinite.
float out_of_range(std::string_view digits, std::chars_format format) {
    double wide = 0.0;
    const std::errc error = std::from_chars(digits.data(), digits.data() + digits.size(), wide, format).ec;
    // Beyond double too: digits carry no sign here, so a minus is the exponent's.
    const bool small = error == std::errc{} ? wide < 1.0 : digits.find('-') != std::string_view::npos;
    return small ? static_cast<float>(wide) : std::numeric_limits<float>::infinity();
}

/// A number without a sign, over the whole of `digits`.
std::optional<float> parse_digits(std::string_view digits, std::chars_format format) {
    if (digits.starts_with('-')) return std::nullopt;
    float value = 0.0f;
    const char* last = digits.data() + digits.size();
    const auto [end, error] = std::from_chars(digits.data(), last, value, format);
    if (error == std::errc::invalid_argument || end != last) return std::nullopt;
    return error == std::errc{} ? value : out_of_range(digits, format);
}

/// Decimal or hexadecimal, with a sign and 0x where wanted.
std::optional<float> parse_float(std::string_view text) {
    const bool negative = text.starts_with('-');
    if (negative || text.starts_with('+')) text.remove_prefix(1);
    std::optional<float> value;
    if (text.starts_with("0x") || text.starts_with("0X")) {
        value = parse_digits(text.substr(2), std::chars_format::hex);
    } else {
        value = parse_digits(text, std::chars_format::general);
        const bool power_of_two = text.find_first_of("pP") != std::string_view::npos;
        if (!value && power_of_two) value = parse_digits(text, std::chars_format::hex);
    }
    if (value && negative) value = -*value;
    return value;
}

bool names_infinity(std::string_view text) { return text.find_first_of("iI") != std::string_view::npos; }

float read_cell(std::string_view cell, const Column& column, const Place& place) {
    const std::optional<float> value = parse_float(cell);
    const std::string where = "column " + std::string(column.name) + ": ";
    if (!value) place.fail(where + "'" + printable(cell, 40) + "' is not a number");
    if (std::isinf(*value) && !names_infinity(cell)) {
        place.fail(where + printable(cell, 40) + " is beyond the largest float, 3.4e38");
    }
    // The tracers know no infinite interval.
    if (column.name == "tmax" && *value > KD_T_LIMIT) return KD_T_LIMIT;
    return *value;
}

std::vector<const Column*> read_header(std::string_view line, const Place& place) {
    std::vector<const Column*> header;
    for (const std::string_view cell : cells_of(line, columns.size())) {
        const Column* column = std::ranges::find(columns, cell, &Column::name);
        if (column == columns.end()) {
            place.fail("unknown column '" + printable(cell, 40) + "'; " + std::string(header_help));
        }
        if (std::ranges::find(header, column) != header.end()) {
            place.fail("column " + std::string(cell) + " comes twice");
        }
        header.push_back(column);
    }
    for (const Column& column : columns) {
        if (column.required && std::ranges::find(header, &column) == header.end()) {
            place.fail("column " + std::string(column.name) + " is missing; " + std::string(header_help));
        }
    }
    return header;
}

Ray read_ray(std::string_view line, const std::vector<const Column*>& header, const Place& place) {
    const std::vector<std::string_view> cells = cells_of(line, header.size());
    if (cells.size() != header.size()) {
        place.fail(std::to_string(1 + std::ranges::count(line, ',')) + " values for " + std::to_string(header.size()) +
                   " columns");
    }
    Ray ray;
    ray.t_min = 0.0f;
    ray.t_max = KD_T_LIMIT;
    ray.source = -1;
    for (std::size_t i = 0; i < cells.size(); ++i) header[i]->field(ray) = read_cell(cells[i], *header[i], place);
    return ray;
}

}  // namespace

std::vector<Ray> read_rays_csv(const std::filesystem::path& path) {
    return parse_rays_csv(read_file(path), path.string());
}

std::vector<Ray> parse_rays_csv(std::string_view text, const std::string& file) {
    std::string_view rest = text;
    if (rest.starts_with("\xef\xbb\xbf")) rest.remove_prefix(3);  // byte order mark of some spreadsheets

    Place place{file};
    std::vector<const Column*> header;
    std::vector<Ray> rays;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const std::string_view line = trimmed(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
        ++place.line;
        if (line.empty()) continue;
        if (header.empty()) {
            header = read_header(line, place);
        } else {
            if (rays.size() == largest_ray_count) {
                place.fail("more than " + std::to_string(largest_ray_count) + " rays; split the file");
            }
            rays.push_back(read_ray(line, header, place));
        }
    }
    if (header.empty()) throw InputError(printable(place.file, 4096) + ": empty; " + std::string(header_help));
    return rays;
}

std::string hex_float(float value) {
    if (!std::isfinite(value)) return std::isnan(value) ? "nan" : value > 0.0f ? "inf" : "-inf";
    std::array<char, 32> digits;
    const char* const end =
        std::to_chars(digits.data(), digits.data() + digits.size(), std::abs(value), std::chars_format::hex).ptr;
    return (std::signbit(value) ? "-0x" : "0x") +
           std::string(digits.data(), static_cast<std::size_t>(end - digits.data()));
}

std::string rays_csv(std::span<const Ray> rays) {
    std::string text;
    for (const Column& column : columns) text += std::string(text.empty() ? "" : ",") + std::string(column.name);
    text += '\n';
    for (Ray ray : rays) {
        for (const Column& column : columns) {
            text += hex_float(column.field(ray));
            text += &column == &columns.back() ? '\n' : ',';
        }
    }
    return text;
}

}  // namespace kd
