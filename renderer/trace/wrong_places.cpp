#include "renderer/trace/wrong_places.h"

#include <algorithm>
#include <cstdlib>

namespace kd {

namespace {

struct Position {
    int x, y;
};

Position position(std::size_t index, int width) {
    return {int(index % std::size_t(width)), int(index / std::size_t(width))};
}

int distance(Position a, Position b) { return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)); }

/// Counts wrong pixels in rectangles, each in a few steps: entry (x, y) holds those left of x and above y.
class Sums {
  public:
    explicit Sums(const Image<JudgedHit>& hits) : sums_(hits.width + 1, hits.height + 1) {
        for (int y = 0; y < hits.height; ++y)
            for (int x = 0; x < hits.width; ++x)
                sums_.at(x + 1, y + 1) =
                    int(is_wrong(hits.at(x, y).verdict)) + sums_.at(x, y + 1) + sums_.at(x + 1, y) - sums_.at(x, y);
    }

    /// Within `reach` of a pixel.
    [[nodiscard]] int around(Position p, int reach) const {
        const int x0 = std::max(p.x - reach, 0), x1 = std::min(p.x + reach + 1, sums_.width - 1);
        const int y0 = std::max(p.y - reach, 0), y1 = std::min(p.y + reach + 1, sums_.height - 1);
        return sums_.at(x1, y1) - sums_.at(x0, y1) - sums_.at(x1, y0) + sums_.at(x0, y0);
    }

  private:
    Image<int> sums_;
};

/// Places in cells as wide as their reach, of which each has room for one.
class Apart {
  public:
    Apart(int width, int height, int reach) : reach_(reach), cells_(width / reach + 1, height / reach + 1, nowhere) {}

    /// Keeps the place, unless it is within reach of one before.
    bool keep(Position p) {
        const int cx = p.x / reach_, cy = p.y / reach_;
        for (int y = cy - 1; y <= cy + 1; ++y)
            for (int x = cx - 1; x <= cx + 1; ++x)
                if (cells_.contains(x, y) && cells_.at(x, y).x >= 0 && distance(cells_.at(x, y), p) <= reach_)
                    return false;
        cells_.at(cx, cy) = p;
        return true;
    }

  private:
    static constexpr Position nowhere{-1, -1};
    int reach_;
    Image<Position> cells_;
};

}  // namespace

int place_reach(int width, int height) { return std::max(8, std::min(width, height) / 24); }

std::vector<std::size_t> wrong_places(const Image<JudgedHit>& hits) {
    struct Wrong {
        std::size_t index;
        int around;
    };
    const int reach = place_reach(hits.width, hits.height);
    const Sums sums(hits);
    std::vector<Wrong> wrong;
    for (std::size_t i = 0; i < hits.pixels.size(); ++i)
        if (is_wrong(hits.pixels[i].verdict)) wrong.push_back({i, sums.around(position(i, hits.width), reach)});
    std::ranges::stable_sort(wrong, std::ranges::greater{}, &Wrong::around);
    Apart apart(hits.width, hits.height, reach);
    std::vector<std::size_t> places;
    for (const Wrong& pixel : wrong)
        if (apart.keep(position(pixel.index, hits.width))) places.push_back(pixel.index);
    return places;
}

std::optional<std::size_t> next_place(const JudgedLayer& judged, std::optional<std::size_t> from, bool backwards) {
    const std::vector<std::size_t>& places = judged.places;
    if (places.empty()) return std::nullopt;
    if (!from) return backwards ? places.back() : places.front();
    const int width = judged.hits.width;
    const Position here = position(*from, width);
    const auto away = [&](std::size_t place) { return distance(position(place, width), here); };
    const auto nearest = std::ranges::min_element(places, {}, away);
    if (away(*nearest) > place_reach(width, judged.hits.height)) return *nearest;
    const std::size_t n = places.size(), at = std::size_t(nearest - places.begin());
    return places[(at + (backwards ? n - 1 : 1)) % n];
}

}  // namespace kd
