// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/formats/threemf/XmlText.h"

#include "document/formats/MeshFileErrors.h"
#include "document/formats/MeshTextValues.h"
#include "mesh/structure/CancelPolling.h"

#include <algorithm>

namespace handwheel {

namespace {

constexpr std::size_t kLongestTag = 8 * 1024;
constexpr std::size_t kLongestText = 16 << 20;

// Returns the end of a tag: the first '>' that is not in quotes.
std::size_t endOfTag(std::string_view text, std::size_t at) {
  for (;;) {
    at = text.find_first_of("\"'>", at);
    if (at == std::string_view::npos || text[at] == '>') return at;
    at = text.find(text[at], at + 1);
    if (at == std::string_view::npos) return at;
    ++at;
  }
}

struct Markup {
  std::string_view begin, end;
};
constexpr Markup kQuotedMarkup[] = {{"<!--", "-->"}, {"<![CDATA[", "]]>"}, {"<?", "?>"}};

Error malformed(const char* what, std::size_t at) {
  return {ErrorCode::ElementMalformed, {"XML", what}, InputPosition::byte(at), {}};
}

// Moves past the markup that begins here, or returns an error.
std::optional<Error> pass(std::string_view text, std::size_t& at) {
  const std::size_t begin = at;
  for (const Markup& markup : kQuotedMarkup) {
    if (!text.substr(begin).starts_with(markup.begin)) continue;
    at = std::min(text.find(markup.end, begin), text.size());
    return at - begin > kLongestText ? std::optional(malformed("a comment is too long", begin)) : std::nullopt;
  }
  if (text.substr(begin).starts_with("<!")) return malformed("it has a document type", begin);
  // The look-ahead is limited: a tag without end must not cost the rest of the text each time.
  const std::string_view tag = text.substr(begin, kLongestTag + 1);
  const std::size_t end = endOfTag(tag, 1);
  if (end == std::string_view::npos && tag.size() > kLongestTag) return malformed("a tag is too long", begin);
  at = end == std::string_view::npos ? text.size() : begin + end + 1;
  return {};
}

}  // namespace

std::optional<Error> objectionToXml(std::string_view text, const Progress& progress) {
  if (text.substr(0, 4).find('\0') != std::string_view::npos || text.starts_with("\xfe\xff") ||
      text.starts_with("\xff\xfe")) {
    return Error{MeshFileError::TextEncoding, {"UTF-16"}, {}, {}};
  }
  std::size_t marks = 0;
  for (std::size_t at = 0; at < text.size();) {
    if (++marks % kIterationsPerPoll == 0 && progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    const std::size_t next = std::min(text.find('<', at), text.size());
    if (next - at > kLongestText) return malformed("a text is too long", at);
    at = next;
    if (at == text.size()) break;
    if (auto objection = pass(text, at)) return objection;
  }
  return {};
}

void blankXmlDeclaration(std::string& text) {
  const std::size_t begin = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
  const std::string_view rest = std::string_view(text).substr(begin);
  const std::size_t end = rest.find("?>");
  if (!rest.starts_with("<?xml ") || end == std::string_view::npos) return;
  const std::string_view declaration = rest.substr(0, end);
  std::size_t at = declaration.find("encoding");
  if (at != std::string_view::npos) {
    at = std::min(declaration.find_first_of("\"'", at), declaration.size());
    const std::string_view value = declaration.substr(at).substr(0, 7);
    if (!equalsIgnoringCase(value, "\"utf-8\"") && !equalsIgnoringCase(value, "'utf-8'")) return;
  }
  std::fill_n(text.begin() + static_cast<std::ptrdiff_t>(begin), end + 2, ' ');
}

std::string asciiOf(QStringView value) {
  const QStringView trimmed = value.trimmed();
  std::string text(static_cast<std::size_t>(trimmed.size()), '?');
  for (qsizetype i = 0; i < trimmed.size(); ++i) {
    if (trimmed[i].unicode() < 0x80) text[static_cast<std::size_t>(i)] = static_cast<char>(trimmed[i].unicode());
  }
  return text;
}

}  // namespace handwheel
