// An output stream for people and terminals.
#pragma once

#include <ostream>
#include <streambuf>

namespace kd {

/// Passes text on to another stream with control characters, C1 ones included, as '?': names of files and of what is in
/// them must not reach a terminal as commands. Line feeds and tabs stay.
class PrintableStream final : public std::ostream {
  public:
    explicit PrintableStream(std::ostream& target) : std::ostream(nullptr), buffer_(*target.rdbuf()) {
        rdbuf(&buffer_);
    }
    PrintableStream(const PrintableStream&) = delete;
    PrintableStream& operator=(const PrintableStream&) = delete;
    ~PrintableStream() override = default;

  private:
    class Buffer final : public std::streambuf {
      public:
        explicit Buffer(std::streambuf& target) : target_(target) {}
        ~Buffer() override { release(); }
        Buffer(const Buffer&) = delete;
        Buffer& operator=(const Buffer&) = delete;

      protected:
        int_type overflow(int_type c) override;
        int sync() override;

      private:
        bool release();

        std::streambuf& target_;
        bool held_ = false;  // the byte C2, which begins a C1 control if 80..9F follows
    };
    Buffer buffer_;
};

}  // namespace kd
