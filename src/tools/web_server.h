#pragma once

#include <cstdint>
#include <string>

namespace crowd {

/// @brief Replaces this process by the program web_server, which walks a scenario and shows it in a browser
/// (docs/web.md). @throws FileError if it cannot be started
[[noreturn]] void showInBrowser(const std::string& scenario, const std::string& q_table, std::uint64_t seed,
                                unsigned threads, unsigned port);

}  // namespace crowd
