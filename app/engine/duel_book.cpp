#include "app/engine/duel_book.h"

#include <algorithm>
#include <utility>

namespace kd {

namespace {

constexpr std::size_t most_pages = 8;

}  // namespace

DuelBook::Page* DuelBook::find(const Subject& of) {
    const auto page = std::ranges::find(pages_, of, &Page::of);
    return page == pages_.end() ? nullptr : &*page;
}

void DuelBook::show(const DuelState& rounds) {
    const bool running = shown_.running;
    shown_ = rounds;
    shown_.running = running;
    shown_.outdated = false;
}

void DuelBook::turn_to(Session session, int scale) {
    session.tracer = TracerKind::cpu;
    session.trace.packet_size = TraceConfig{}.packet_size;
    session.view = {};
    Subject subject{std::move(session), scale};
    if (subject == of_) return;
    of_ = std::move(subject);
    warm_ = false;
    if (const Page* page = find(of_))
        show(page->rounds);
    else
        shown_.outdated = true;
}

void DuelBook::add(const DuelReply& reply) {
    Page* page = find(of_);
    if (page && page->rounds.scale != reply.scale) {  // rounds of another size are no rounds of this frame
        std::erase_if(pages_, [&](const Page& p) { return p.of == of_; });
        page = nullptr;
        warm_ = false;
        shown_.outdated = true;
    }
    if (!std::exchange(warm_, true)) return;
    if (!page) {
        pages_.push_front({of_, {}});
        if (pages_.size() > most_pages) pages_.pop_back();
        page = &pages_.front();
    }
    DuelState& duel = page->rounds;
    duel.width = reply.width;
    duel.height = reply.height;
    duel.scale = reply.scale;
    duel.chosen = of_.scale > 0;
    duel.rays = reply.rays;
    duel.cpu_clock = reply.cpu_clock;
    duel.gl_clock = reply.gl_clock;
    duel.gl_setup = reply.gl_setup;
    duel.traversal = of_.session.trace.traversal;
    duel.add(reply.round);
    show(duel);
}

void DuelBook::forget() {
    pages_.clear();
    warm_ = false;
    shown_.outdated = true;
}

}  // namespace kd
