// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/Messages.h"

#include "text/ErrorText.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <new>

namespace handwheel {

void complain(std::string_view sentence) {
  std::fprintf(stderr, "handwheel: %.*s\n", static_cast<int>(sentence.size()), sentence.data());
}

std::string sentenceFor(const Error& error) {
  return errorSentence(error).toStdString();
}

std::string fullSentenceFor(const Error& error) {
  const std::string advice = errorAdvice(error).toStdString();
  return sentenceFor(error) + (advice.empty() ? "" : " " + advice);
}

int fail(const Error& error) {
  if (error.code == ErrorCode::Cancelled) {
    complain("Cancelled.");
    return kExitInterrupted;
  }
  complain(fullSentenceFor(error));
  return kExitError;
}

int failForMemory(const std::string& subject) {
  try {
    return fail({ErrorCode::OutOfMemory, {}, {}, subject});
  } catch (const std::bad_alloc&) {
    return refuse("There is not enough memory.");
  }
}

int refuse(std::string_view sentence) {
  complain(sentence);
  return kExitError;
}

int failUsage(std::string_view sentence, std::string_view command) {
  complain(sentence);
  std::fprintf(stderr, "Try 'handwheel help%s%.*s'.\n", command.empty() ? "" : " ", static_cast<int>(command.size()),
               command.data());
  return kExitError;
}

int print(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) return kExitDone;
  complain(std::string("The output could not be written (") + std::strerror(errno) + ").");
  return kExitError;
}

}  // namespace handwheel
