// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "process/ReaderProgram.h"
#include "step/ShapeMesh.h"
#include "step/StepShape.h"
#include "step/TurnedShape.h"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <new>

// Reads a STEP file for core/document/formats/step/StepReader.cpp. The option is the chord tolerance, as a share of the
// diagonal. The answer is one line: parts of the file and those that were read, solids, open shells, faces and those
// that were lost, the chord tolerance in millimetres, the unit of length; and then the triangles as a PLY file.
//
// With the option "turned" or "turned-lenient" it looks for the half section of a turned part instead: TurnedShape.h.

using namespace handwheel;

namespace {

Result<std::string> answer(std::string_view bytes, double chordShare, Progress progress) {
  const Result<StepShape> read = readShape(bytes, progress.part(0.0, 0.6));
  if (!read) return read.error();
  const Result<ShapeMesh> mesh = meshOf(read->shape, chordShare, progress.part(0.6, 1.0));
  if (!mesh) return mesh.error();
  char line[256];
  std::snprintf(line, sizeof line, "%d %d %d %d %zu %zu %.17g %.32s\n", read->parts, read->partsRead, read->solids,
                read->openShells, mesh->faces, mesh->facesLost, mesh->chord, read->unit.c_str());
  return line + mesh->ply;
}

Result<std::string> answerTurned(std::string_view bytes, bool isLenient, Progress progress) {
  const Result<StepShape> read = readShape(bytes, progress.part(0.0, 0.9));
  if (!read) return read.error();
  return turnedAnswer(read->shape, isLenient);
}

// The library's exceptions as errors.
Result<std::string> readStep(std::string_view bytes, std::span<char* const> options, Progress progress) {
  const std::string_view word = options.empty() ? std::string_view() : options[0];
  const bool isTurned = word.starts_with("turned");
  double chordShare = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), chordShare);
  if (!isTurned && (error != std::errc() || !(chordShare > 0.0)))
    return Error{ErrorCode::LibraryFailed, {"the option is no share"}, {}, {}};
  try {
    Message::DefaultMessenger()->ChangePrinters().Clear();
    if (isTurned) return answerTurned(bytes, word == "turned-lenient", progress);
    return answer(bytes, chordShare, progress);
  } catch (const Standard_OutOfMemory&) {
    throw std::bad_alloc();
  } catch (const Standard_Failure&) {
    return Error{ErrorCode::LibraryFailed, {"it is inconsistent"}, {}, {}};
  }
}

}  // namespace

int main(int argc, char** argv) {
  runReaderProgram(argc, argv, readStep);
}
