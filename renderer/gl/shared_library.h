// A library opened at run time.
#pragma once

#include <string>

namespace kd {

/// Stays open until the process ends: drivers start threads and register exit handlers that must find their code.
class SharedLibrary {
  public:
    /// Its symbols stay private to it. ContextError with the loader's reason.
    explicit SharedLibrary(const char* file);

    /// ContextError where missing.
    template <class Function>
    [[nodiscard]] Function function(const char* name) const {
        return reinterpret_cast<Function>(symbol(name));
    }

  private:
    std::string file_;
    void* handle_;

    [[nodiscard]] void* symbol(const char* name) const;
};

}  // namespace kd
