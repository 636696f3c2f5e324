#include "app/engine/plane_effect.h"

#include <algorithm>
#include <utility>

#include "app/engine/state.h"

namespace kd {

namespace {

/// All of the session that the counters depend on.
Session key_of(Session session) {
    session.view = {};
    session.tracer = TracerKind::cpu;
    session.early_z = EarlyZ::working;
    session.threads = 0;
    session.trace.forced = {};
    session.trace.packet_size = TraceConfig{}.packet_size;
    return session;
}

Session without_planes(Session session) {
    session.build.by_hand.clear();
    return session;
}

}  // namespace

std::array<CounterTotals, pass_count> walk_totals(const Frame& frame) {
    std::array<CounterTotals, pass_count> totals;
    for (int pass = 0; pass < pass_count; ++pass) {
        const std::vector<RayCounters>& counters = frame.layer(Pass(pass)).counters.pixels;
        for (std::size_t i = 0; i < counters.size(); ++i)
            if (ray_traced(frame, Pass(pass), i)) totals[std::size_t(pass)].add(counters[i]);
    }
    return totals;
}

const PlaneBook::Page* PlaneBook::find(const Session& key, const std::shared_ptr<const LoadedScene>& loaded) const {
    const auto found = std::ranges::find_if(
        without_, [&](const Page& page) { return page.loaded.lock() == loaded && page.session == key; });
    return found == without_.end() ? nullptr : &*found;
}

void PlaneBook::note(const TracedFrame& traced, const Session& session) {
    Page page{key_of(session), traced.world->loaded, {traced.totals, traced.world->stats.sah_cost}};
    now_ = page;
    if (!session.build.by_hand.empty()) return;
    std::erase_if(without_, [&](const Page& old) {
        return old.loaded.expired() || (old.loaded.lock() == traced.world->loaded && old.session == page.session);
    });
    if (without_.size() == most_pages) without_.erase(without_.begin());
    without_.push_back(std::move(page));
}

void PlaneBook::turn_to(const Session& session, const std::shared_ptr<const LoadedScene>& loaded) {
    const Session key = key_of(session);
    effect_ = {};
    effect_.planes = !session.build.by_hand.empty();
    if (now_ && now_->loaded.lock() == loaded && now_->session == key) effect_.now = now_->walks;
    if (const Page* page = find(without_planes(key), loaded)) effect_.without = page->walks;
}

}  // namespace kd
