// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/step/StepReader.h"

#include "base/NumberText.h"
#include "document/formats/step/StepAnswer.h"
#include "process/IsolatedReader.h"

namespace handwheel {

namespace {

IsolatedReader stepReader(std::size_t bytes) {
  IsolatedReader reader{readerProgram("step"), kStepLibrary, {}};
  // Limit of the time per size: the library reads a megabyte in about three seconds, and slow machines must finish,
  // too.
  constexpr std::size_t kMegabyte = 1 << 20;
  reader.limits.cpu += std::chrono::seconds(20 * bytes / kMegabyte);
  reader.limits.wall = 2 * reader.limits.cpu;
  return reader;
}

}  // namespace

bool looksLikeStep(std::string_view bytes) {
  return bytes.starts_with("ISO-10303-21");
}

Result<MeshFile> readStep(std::string_view bytes, const ReadOptions& options, Progress progress) {
  const Result<std::string> answer =
      readIsolated(stepReader(bytes.size()), {shortestText(options.stepChord)}, bytes, progress.part(0.0, 0.9));
  if (!answer) return answer.error();
  return meshIn(*answer, options, progress.part(0.9, 1.0));
}

}  // namespace handwheel
