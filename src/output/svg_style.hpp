#pragma once

// Private to output/: the look of all pictures.

#include <string_view>

namespace blockfsi::output::svg
{

/// Number of colours; line styles c0, c1, ... repeat after it.
inline constexpr int colour_count = 12;

/// Colours of Okabe & Ito 2008, told apart by most colour-blind people, with dashes for print in grey.
inline constexpr std::string_view style =
    "<style>"
    ".page{fill:#fff}text{font:13px system-ui,sans-serif;fill:#222}.title{font-size:15px;font-weight:600}"
    ".small{font-size:12px}.axis{stroke:#555;fill:none}.grid{stroke:#ddd;fill:none}"
    ".line{fill:none;stroke-width:1.8;stroke-linejoin:round}.end{stroke-width:2.2;fill:none}"
    ".mesh{fill:none;stroke:#333;stroke-width:5}.body{fill:#f2b179;stroke:#a65b1b;stroke-width:5}"
    ".edge{fill:none;stroke:#000;stroke-width:14}.bad{fill:#e4002b;fill-opacity:.75;stroke:none}"
    ".ring{fill:none;stroke:#e4002b;stroke-width:22}"
    ".c0{stroke:#000}.c1{stroke:#0072b2;stroke-dasharray:9 3}.c2{stroke:#d55e00;stroke-dasharray:3 3}"
    ".c3{stroke:#009e73;stroke-dasharray:9 3 2 3}.c4{stroke:#b5498d;stroke-dasharray:14 4}"
    ".c5{stroke:#c78500;stroke-dasharray:2 2}.c6{stroke:#3b9fd1;stroke-dasharray:6 2 2 2 2 2}"
    ".c7{stroke:#777;stroke-dasharray:5 5}.c8{stroke:#7a3fc0;stroke-dasharray:12 3 3 3}"
    ".c9{stroke:#8a5a2b;stroke-dasharray:4 2}.c10{stroke:#5a7d00;stroke-dasharray:1 3}"
    ".c11{stroke:#b00020;stroke-dasharray:16 3 4 3}"
    "@media(prefers-color-scheme:dark){"
    ".page{fill:#14171a}text{fill:#ddd}.axis{stroke:#aaa}.grid{stroke:#33383d}.mesh{stroke:#b8bec4}.edge{"
    "stroke:#fff}"
    ".body{fill:#8a4b16;stroke:#f2b179}.bad{fill:#ff5470}.ring{stroke:#ff5470}"
    ".c0{stroke:#fff}.c1{stroke:#4ea8de}.c2{stroke:#ff8a3d}.c3{stroke:#2fd0a0}.c4{stroke:#e58cc4}"
    ".c5{stroke:#f0b429}.c6{stroke:#8fd3f4}.c7{stroke:#999}"
    ".c8{stroke:#b794f4}.c9{stroke:#d3a06f}.c10{stroke:#b5d65a}.c11{stroke:#ff7a8a}}"
    "</style>";

}  // namespace blockfsi::output::svg
