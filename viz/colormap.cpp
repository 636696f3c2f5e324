#include "viz/colormap.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

#include "renderer/geometry/input_error.h"

namespace kd {
namespace {

template <std::size_t n>
constexpr std::array<Rgba8, n> colours(const std::uint32_t (&rgb)[n]) {
    std::array<Rgba8, n> table;
    for (std::size_t i = 0; i < n; ++i) {
        table[i] = {static_cast<unsigned char>(rgb[i] >> 16), static_cast<unsigned char>(rgb[i] >> 8 & 255),
                    static_cast<unsigned char>(rgb[i] & 255), 255};
    }
    return table;
}

// The first six are the published 256-entry maps sampled at 33 even steps and rounded. Linear interpolation between the
// samples stays within 2/255 of the published entries for viridis, magma, inferno and turbo, 4/255 for plasma and
// 6/255 for cividis (near its dark end, where blue has a kink).

// van der Walt & Smith, "A Better Default Colormap for Matplotlib", SciPy 2015.
constexpr auto viridis = colours(
    {0x440154, 0x470d60, 0x48186a, 0x482374, 0x472d7b, 0x453681, 0x424086, 0x3f4989, 0x3b528b, 0x375a8d, 0x33638d,
     0x2f6a8e, 0x2c728e, 0x297a8e, 0x26818e, 0x23898e, 0x21908c, 0x1f988b, 0x1f9f88, 0x21a685, 0x28ae80, 0x31b57b,
     0x3ebc74, 0x4cc26c, 0x5dc963, 0x6ece58, 0x82d34c, 0x96d83f, 0xabdc32, 0xc0df24, 0xd5e21a, 0xeae51a, 0xfde725});
constexpr auto magma = colours(
    {0x000004, 0x030311, 0x0a0822, 0x130d33, 0x1d1146, 0x28115a, 0x36106a, 0x430f76, 0x50127c, 0x5d177f, 0x691c81,
     0x762181, 0x822681, 0x8f2a81, 0x9c2e7f, 0xa9327d, 0xb63779, 0xc33b75, 0xcf4170, 0xdb486a, 0xe65163, 0xee5c5e,
     0xf5695c, 0xf9785d, 0xfb8761, 0xfd9668, 0xfea571, 0xfeb47b, 0xfec387, 0xfed194, 0xfde0a2, 0xfceeb0, 0xfcfdbf});
constexpr auto inferno = colours(
    {0x000004, 0x040312, 0x0b0724, 0x150b37, 0x210c4a, 0x2e0a5a, 0x3c0965, 0x4a0c6b, 0x57106d, 0x63146e, 0x70196e,
     0x7d1e6d, 0x89226a, 0x962766, 0xa32b61, 0xaf315c, 0xbb3755, 0xc63e4d, 0xd14644, 0xdb4f3b, 0xe35932, 0xeb6528,
     0xf1711e, 0xf67f14, 0xf98d0a, 0xfb9c06, 0xfcab0f, 0xfbba1f, 0xf9ca32, 0xf5d949, 0xf2e865, 0xf3f586, 0xfcffa4});
constexpr auto plasma = colours(
    {0x0d0887, 0x220690, 0x310596, 0x3f049c, 0x4c02a1, 0x5901a5, 0x6600a7, 0x7201a8, 0x7e03a8, 0x8909a6, 0x9511a2,
     0x9f1a9c, 0xa92396, 0xb22c8e, 0xbb3587, 0xc33e80, 0xcb4778, 0xd25071, 0xd9596a, 0xe06263, 0xe66c5c, 0xeb7555,
     0xf07f4f, 0xf48a48, 0xf89441, 0xfb9f3a, 0xfdab33, 0xfeb72d, 0xfdc328, 0xfcd025, 0xf9dd25, 0xf5eb27, 0xf0f921});
// Nunez, Anderton & Renslow, "Optimizing colormaps with consideration for color vision deficiency", PLOS ONE 13(7),
// 2018.
constexpr auto cividis = colours(
    {0x00224e, 0x00285b, 0x002e6a, 0x043371, 0x1a386f, 0x273e6e, 0x32436d, 0x3b496c, 0x434e6c, 0x4b546c, 0x52596d,
     0x5a5f6e, 0x61656f, 0x686a71, 0x6f7073, 0x757676, 0x7c7b78, 0x848179, 0x8b8778, 0x938d78, 0x9b9376, 0xa39a75,
     0xaba072, 0xb3a670, 0xbbad6c, 0xc3b469, 0xccba64, 0xd4c15f, 0xddc958, 0xe6d051, 0xefd748, 0xf8df3c, 0xfee838});
// Mikhailov, "Turbo, An Improved Rainbow Colormap for Visualization", 2019.
constexpr auto turbo = colours(
    {0x30123b, 0x392a73, 0x4040a1, 0x4456c7, 0x466be3, 0x467ff6, 0x4293ff, 0x37a7fa, 0x29bbec, 0x1dcdd8, 0x18dcc3,
     0x1ee8b0, 0x31f299, 0x4cf97e, 0x6bfd64, 0x8aff4d, 0xa3fd3c, 0xb8f735, 0xcced34, 0xdee037, 0xedd03a, 0xf8c03a,
     0xfdae35, 0xfe982c, 0xfb8022, 0xf56817, 0xec520f, 0xe04009, 0xd23105, 0xc02302, 0xac1701, 0x950d01, 0x7a0403});
constexpr auto grey = colours({0x000000, 0xffffff});
// Our own: equal luminance on both arms (within 0.01), light neutral centre.
constexpr auto blue_grey_orange =
    colours({0x0f3a80, 0x2560a8, 0x5288c4, 0x94b3d1, 0xd4d4d4, 0xd6a680, 0xb8763d, 0x8f5017, 0x613003});

constexpr Rgba8 colour(std::uint32_t rgb) { return colours({rgb})[0]; }

// Beyond the ends it goes on where it can: darker than the darkest, lighter than the lightest. Maps that begin with
// black have a dark green for less than that, and those that end light have what they lack, a light green or blue, for
// more. The signed map has green for less: it colours cells, beside which pale blue is the ray's.
constexpr Rgba8 black = colour(0x000000), white = colour(0xffffff), dark_green = colour(0x0a5f50),
                pale_blue = colour(0x8fe3ff), blue = colour(0x0072b2), orange = colour(0xe69f00),
                yellow = colour(0xffe14d), green = colour(0x00c853);

constexpr auto table = std::to_array<Colormap>({
    {"viridis", "dark blue to yellow; even steps look even, and stay so without colour vision", false, viridis, black,
     white},
    {"cividis", "blue to yellow; looks nearly the same to people with and without red-green blindness", false, cividis,
     black, white},
    {"magma", "black over purple to cream; even steps", false, magma, dark_green, pale_blue},
    {"inferno", "black over red to pale yellow; even steps", false, inferno, dark_green, pale_blue},
    {"plasma", "blue over pink to yellow; even steps", false, plasma, black, white},
    {"grey", "black to white", false, grey, blue, orange},
    {"turbo", "rainbow; many distinct colours, but neither even nor safe for colour-blind readers", false, turbo, black,
     white},
    {"blue-grey-orange", "signed numbers: blue below zero, grey at zero, orange above", true, blue_grey_orange, green,
     yellow},
});

constexpr auto categories = colours({0x31536b, 0x56b4e9, 0xe69f00, 0xd55e00, 0xcc79a7, 0x009e73, 0xf0e442, 0x9a9aa2});

unsigned char mix_channel(unsigned char a, unsigned char b, float x) {
    const float value = float(a) + (float(b) - float(a)) * x;
    return static_cast<unsigned char>(value + 0.5f);
}

}  // namespace

Rgba8 mix(Rgba8 a, Rgba8 b, float x) {
    return {mix_channel(a.r, b.r, x), mix_channel(a.g, b.g, x), mix_channel(a.b, b.b, x), mix_channel(a.a, b.a, x)};
}

Rgba8 Colormap::operator()(float x) const {
    if (!(x > 0)) return table.front();
    if (x >= 1) return table.back();
    const float position = x * float(table.size() - 1);
    const auto first = std::min(static_cast<std::size_t>(position), table.size() - 2);
    return mix(table[first], table[first + 1], position - float(first));
}

std::span<const Colormap> colormaps() { return table; }

const Colormap* find_colormap(std::string_view name) {
    const auto* const found = std::ranges::find(table, name, &Colormap::name);
    return found == table.end() ? nullptr : found;
}

const Colormap& get_colormap(std::string_view name) {
    if (const Colormap* found = find_colormap(name)) return *found;
    std::string message = "colour map '" + std::string(name) + "': not known; choose one of";
    for (const Colormap& map : table) message += ' ' + std::string(map.name);
    throw InputError(message);
}

Rgba8 category_colour(int index) {
    const int n = int(categories.size());
    return categories[static_cast<std::size_t>((index % n + n) % n)];
}

}  // namespace kd
