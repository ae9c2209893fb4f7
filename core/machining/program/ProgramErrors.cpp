// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/ProgramErrors.h"

namespace handwheel {

const ErrorDescription ProgramError::Refused{.id = "ProgramRefused",
                                             .sentences = {translatable("ErrorText", "column %1, %2: %3")},
                                             .advice = {translatable("ErrorText", "%4 Then run the program again.")}};

const ErrorDescription ProgramError::Endless{
    .id = "ProgramEndless",
    .sentences = {translatable("ErrorText", "the program did not end after %1 blocks")},
    .advice = {translatable("ErrorText", "Look for a loop whose condition never becomes false.")}};

const ErrorDescription ProgramError::TooManyMoves{
    .id = "ProgramTooManyMoves",
    .sentences = {translatable("ErrorText", "the tool path has more than %1 moves")},
    .advice = {translatable("ErrorText", "Take a larger depth of cut, or divide the program.")}};

const ErrorDescription ProgramError::CyclesCollide{
    .id = "ProgramCyclesCollide",
    .sentences = {translatable("ErrorText", "the cycles collide in line %1")},
    .advice = {translatable("ErrorText", "Take a smaller nose or depth of cut.")}};

const ErrorDescription ProgramError::CyclesGouge{
    .id = "ProgramCyclesGouge",
    .sentences = {translatable("ErrorText", "the cycles cut %1 mm into the target at Z %2")},
    .advice = {translatable("ErrorText", "Take a smaller nose.")}};

void refuse(const SourceLocation& location, const std::string& word, const std::string& reason,
            const std::string& remedy) {
  constexpr std::size_t kMostShown = 40;
  std::string shown = word.substr(0, kMostShown);
  for (char& c : shown)
    if (static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) > '~') c = '?';
  throw ProgramRefusal{{ProgramError::Refused,
                        {std::to_string(location.column), shown, reason, remedy},
                        InputPosition::line(location.line),
                        {}}};
}

}  // namespace handwheel
