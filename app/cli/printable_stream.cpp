#include "app/cli/printable_stream.h"

#include <utility>

namespace kd {

namespace {

constexpr char held_byte = '\xc2';

}  // namespace

/// Passes on what waited for its second byte.
bool PrintableStream::Buffer::release() {
    return !std::exchange(held_, false) || !traits_type::eq_int_type(target_.sputc(held_byte), traits_type::eof());
}

PrintableStream::Buffer::int_type PrintableStream::Buffer::overflow(int_type c) {
    if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
    const char given = traits_type::to_char_type(c);
    const auto byte = static_cast<unsigned char>(given);
    if (held_ && byte >= 0x80 && byte < 0xa0) {
        held_ = false;
        return target_.sputc('?');
    }
    if (!release()) return traits_type::eof();
    if (given == held_byte) {
        held_ = true;
        return c;
    }
    const bool control = (byte < 0x20 && given != '\n' && given != '\t') || byte == 0x7f;
    return target_.sputc(control ? '?' : given);
}

int PrintableStream::Buffer::sync() { return release() && target_.pubsync() == 0 ? 0 : -1; }

}  // namespace kd
