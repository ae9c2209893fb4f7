// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/ProgramErrors.h"

namespace handwheel {

const ErrorDescription ProgramError::Refused{.id = "ProgramRefused",
                                             .sentences = {translatable("ErrorText", "column %1, %2: %3")},
                                             .advice = {translatable("ErrorText", "%4 Then run the program again.")}};

const ErrorDescription ProgramError::Unmakeable{
    .id = "ProgramUnmakeable",
    .sentences = {translatable("ErrorText", "%2: %3")},
    .advice = {translatable("ErrorText", "%4 Then make the program again.")}};

const ErrorDescription ProgramError::Alarm{
    .id = "ProgramAlarm",
    .sentences = {translatable("ErrorText", "the program stops with the alarm %1: %2"),
                  translatable("ErrorText", "the program stops with the alarm %1")},
    .advice = {translatable("ErrorText",
                            "A control stops here, too, before the next move. Look at the condition of the alarm.")}};

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

namespace {

// Returns the first characters of a text of the program, without those that cannot be shown.
std::string shownText(const std::string& text, std::size_t most) {
  std::string shown = text.substr(0, most);
  for (char& c : shown)
    if (static_cast<unsigned char>(c) < ' ' || static_cast<unsigned char>(c) > '~') c = '?';
  return shown;
}

}  // namespace

void alarm(const SourceLocation& location, const std::string& number, const std::string& message) {
  constexpr std::size_t kMostMessage = 100;
  throw ProgramRefusal{
      {ProgramError::Alarm, {number, shownText(message, kMostMessage)}, InputPosition::line(location.line), {}}};
}

void refuse(const SourceLocation& location, const std::string& word, const std::string& reason,
            const std::string& remedy) {
  constexpr std::size_t kMostShown = 40;
  const std::string shown = shownText(word, kMostShown);
  const std::vector<std::string> arguments = {std::to_string(location.column), shown, reason, remedy};
  if (location.line == 0) throw ProgramRefusal{{ProgramError::Unmakeable, arguments, {}, {}}};
  throw ProgramRefusal{{ProgramError::Refused, arguments, InputPosition::line(location.line), {}}};
}

}  // namespace handwheel
