// Help in lines of at most 100 columns.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace kd {

/// A name and what it means, as one entry of a list in the help.
struct HelpEntry {
    std::string name, text;
};

/// "TITLE:" and the entries below it, their texts in one column, wrapped.
[[nodiscard]] std::string help_list(std::string_view title, const std::vector<HelpEntry>& entries);

/// CLI11's layout with wrapped texts.
class HelpFormatter : public CLI::Formatter {
  public:
    HelpFormatter();
    std::string make_group(std::string group, bool is_positional,
                           std::vector<const CLI::Option*> options) const override;
    std::string make_option(const CLI::Option* option, bool is_positional) const override;
    std::string make_subcommand(const CLI::App* sub) const override;
};

}  // namespace kd
