#pragma once

#include <string_view>

/// What each target defines: reads the bytes as a file. Bad input must end in blockfsi::Error and nothing
/// else: any other exception, crash, report of a sanitizer, long time or much memory is a finding.
void read_input(std::string_view content);
