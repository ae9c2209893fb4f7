// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Translatable.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace handwheel {

// The description of an error code: its identifier and its texts.
//
// A module declares its codes beside the functions that raise them: `extern const ErrorDescription Unreachable;` in a
// namespace of the module, with the arguments in a comment. An argument is empty if it is not known; {what} is an
// English plural ("facets", "bytes", ...). The texts are English, marked with translatable("ErrorText", ...), and
// translated when they are displayed. The first argument replaces %1. If there are several texts, the first text whose
// arguments are all known is used, or else the last text.
struct ErrorDescription {
  // Prevents copies, because the address is the identity of the code.
  struct Uncopied {
    constexpr Uncopied() = default;
    Uncopied(const Uncopied&) = delete;
  };

  const char* id;                    // name of the code; unique in the program, and never changed
  const char* sentences[3] = {};     // texts without capital and full stop; the position in a file may precede them
  const char* advice[2] = {};        // the remedy, as a whole sentence
  bool mayBePartlyReadable = false;  // true if only some content of the file is damaged
  std::optional<std::size_t> alternatives = {};  // index of the first argument of a list: ".stl, .ply or .obj"
  Uncopied identity = {};
};

// The advice for damage to some content of a file.
inline constexpr const char* kOpenReadableAdvice = translatable(
    "ErrorText", "Export or copy the file again, or open only what is readable (on the command line: --partial).");

// An error code: a reference to a description. The constants are codes that any module may raise; their comments list
// the arguments.
class ErrorCode {
 public:
  static const ErrorDescription Cancelled;
  static const ErrorDescription OutOfMemory;
  static const ErrorDescription FileMissing;     // no such file
  static const ErrorDescription FileUnreadable;  // {system's reason}
  static const ErrorDescription FileEmpty;
  static const ErrorDescription FileTooLarge;      // {what, count, limit}
  static const ErrorDescription WriteFailed;       // {system's reason}
  static const ErrorDescription HeaderMalformed;   // {what was expected}
  static const ErrorDescription VersionNewer;      // {version of the file, newest known}: written by a newer program
  static const ErrorDescription DataTruncated;     // {what, expected, found}: the file ends too early
  static const ErrorDescription CountMismatch;     // {what, announced, found}
  static const ErrorDescription NumberMalformed;   // {found}
  static const ErrorDescription NumberNotFinite;   // {found}
  static const ErrorDescription ElementMalformed;  // {element, what is wrong with it}: in XML or JSON
  static const ErrorDescription
      ReferenceMissing;  // {what, name, folder}: no such object in the searched folder and its parents
  static const ErrorDescription ValueOutOfRange;  // {name, value, least, largest}
  static const ErrorDescription Unsupported;      // {what}: understood, but not supported by this program
  static const ErrorDescription LibraryFailed;    // {library, reason}

  constexpr ErrorCode() : ErrorCode(Cancelled) {}
  constexpr ErrorCode(const ErrorDescription& description) : m_description(&description) {}
  ErrorCode(const ErrorDescription&&) = delete;

  constexpr const ErrorDescription* operator->() const { return m_description; }
  friend constexpr bool operator==(ErrorCode a, ErrorCode b) { return a.m_description == b.m_description; }

 private:
  const ErrorDescription* m_description;
};

// A position in the input. It is a byte offset in binary files, and a line number (from 1) in text files.
struct InputPosition {
  enum class Kind { None, Byte, Line };
  Kind kind = Kind::None;
  std::uint64_t value = 0;

  static InputPosition byte(std::uint64_t offset) { return {Kind::Byte, offset}; }
  static InputPosition line(std::uint64_t number) { return {Kind::Line, number}; }
};

// An error with its code, arguments and position in the input.
struct Error {
  ErrorCode code;
  std::vector<std::string> arguments;
  InputPosition position;
  std::string subject;  // the file concerned, as the user named it; empty: no file
};

}  // namespace handwheel
