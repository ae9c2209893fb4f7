// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/lathe/LatheRecording.h"

namespace handwheel {

LatheRun replay(const LatheRecording& recording, LatheTools tools, Progress progress,
                const std::function<void(const LatheStep&)>& seen) {
  constexpr std::uint64_t kCheckEvery = 1024;
  LatheRun run(recording.setup, std::move(tools), *recording.part, recording.start, recording.material);
  std::vector<LatheCommand> commands;
  std::size_t next = 0;
  for (std::uint64_t i = 0; i < recording.steps; ++i) {
    if (i % kCheckEvery == 0) {
      if (progress.cancelled()) break;
      progress.set(static_cast<double>(i) / static_cast<double>(recording.steps));
    }
    commands.clear();
    for (; next < recording.entries.size() && recording.entries[next].step <= i; ++next)
      commands.push_back(recording.entries[next].command);
    const LatheStep step = run.step(recording.dt, commands);
    if (seen) seen(step);
  }
  return run;
}

}  // namespace handwheel
