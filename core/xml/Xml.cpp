// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "xml/Xml.h"

#include <expat.h>

#include <algorithm>
#include <memory>
#include <new>
#include <optional>

namespace handwheel {

namespace {

struct FreeParser {
  void operator()(XML_Parser parser) const { XML_ParserFree(parser); }
};

bool isBlank(std::string_view text) {
  return text.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

// Builds the tree from the parser's events.
class TreeBuilder {
 public:
  TreeBuilder(XML_Parser parser, const XmlLimits& limits) : m_parser(parser), m_limits(limits) {
    XML_SetUserData(parser, this);
    XML_SetElementHandler(parser, onStart, onEnd);
    XML_SetCharacterDataHandler(parser, onText);
    XML_SetEntityDeclHandler(parser, onEntity);
  }

  XmlElement takeRoot() { return std::move(m_root); }
  const std::optional<Error>& failure() const { return m_failure; }

 private:
  static void XMLCALL onStart(void* self, const char* name, const char** attributes) {
    static_cast<TreeBuilder*>(self)->guarded([&](TreeBuilder& b) { b.start(name, attributes); });
  }
  static void XMLCALL onEnd(void* self, const char*) {
    static_cast<TreeBuilder*>(self)->guarded([](TreeBuilder& b) { b.end(); });
  }
  static void XMLCALL onText(void* self, const char* text, int length) {
    static_cast<TreeBuilder*>(self)->guarded(
        [&](TreeBuilder& b) { b.m_open.back()->text.append(text, static_cast<std::size_t>(length)); });
  }
  static void XMLCALL onEntity(void* self, const char*, int, const char*, int, const char*, const char*, const char*,
                               const char*) {
    static_cast<TreeBuilder*>(self)->guarded([](TreeBuilder& b) {
      b.stop({ErrorCode::Unsupported, {"XML that declares entities"}, b.here(), {}});
    });
  }

  // Calls a handler. No exception may pass through the C library.
  template <class Handler>
  void guarded(Handler handler) {
    if (m_failure) return;
    try {
      handler(*this);
    } catch (const std::bad_alloc&) {
      stop({ErrorCode::OutOfMemory, {}, {}, {}});
    }
  }

  InputPosition here() const { return InputPosition::line(XML_GetCurrentLineNumber(m_parser)); }

  void stop(Error error) {
    m_failure = std::move(error);
    XML_StopParser(m_parser, XML_FALSE);
  }

  void start(const char* name, const char** attributes) {
    if (++m_elements > m_limits.elements)
      return stop({ErrorCode::FileTooLarge, {"elements", "", std::to_string(m_limits.elements)}, here(), {}});
    if (m_open.size() >= m_limits.depth)
      return stop({ErrorCode::ElementMalformed, {name, "elements are nested too deeply"}, here(), {}});
    XmlElement* element = &m_root;
    if (!m_open.empty()) element = &m_open.back()->children.emplace_back();
    element->name = name;
    element->line = here().value;
    for (; *attributes; attributes += 2) {
      if (++m_attributes > 8 * m_limits.elements)
        return stop({ErrorCode::FileTooLarge, {"attributes", "", std::to_string(8 * m_limits.elements)}, here(), {}});
      element->attributes.push_back({attributes[0], attributes[1]});
    }
    m_open.push_back(element);
  }

  void end() {
    std::string& text = m_open.back()->text;
    if (isBlank(text)) text = {};
    m_open.pop_back();
  }

  XML_Parser m_parser;
  const XmlLimits& m_limits;
  XmlElement m_root;
  // The open elements, from the root to the innermost. The pointers stay valid because only the innermost element gets
  // children.
  std::vector<XmlElement*> m_open;
  std::size_t m_elements = 0, m_attributes = 0;
  std::optional<Error> m_failure;
};

}  // namespace

const std::string* XmlElement::attribute(std::string_view wanted) const {
  const auto found =
      std::find_if(attributes.begin(), attributes.end(), [&](const auto& a) { return a.name == wanted; });
  return found == attributes.end() ? nullptr : &found->value;
}

const XmlElement* XmlElement::child(std::string_view wanted) const {
  const auto found = std::find_if(children.begin(), children.end(), [&](const auto& c) { return c.name == wanted; });
  return found == children.end() ? nullptr : &*found;
}

Result<XmlElement> readXml(std::string_view bytes, const XmlLimits& limits, Progress progress) {
  if (bytes.size() > limits.bytes) {
    return Error{
        ErrorCode::FileTooLarge, {"bytes", std::to_string(bytes.size()), std::to_string(limits.bytes)}, {}, {}};
  }
  const std::unique_ptr<XML_ParserStruct, FreeParser> parser(XML_ParserCreate(nullptr));
  if (!parser) return Error{ErrorCode::OutOfMemory, {}, {}, {}};
  TreeBuilder builder(parser.get(), limits);
  constexpr std::size_t kSlice = std::size_t{1} << 18;
  for (std::size_t at = 0; at == 0 || at < bytes.size(); at += kSlice) {
    if (progress.cancelled()) return Error{ErrorCode::Cancelled, {}, {}, {}};
    progress.set(static_cast<double>(at) / static_cast<double>(std::max<std::size_t>(bytes.size(), 1)));
    const std::string_view slice = bytes.substr(at, kSlice);
    const bool isLast = at + kSlice >= bytes.size();
    const auto status = XML_Parse(parser.get(), slice.data(), static_cast<int>(slice.size()), isLast);
    if (builder.failure()) return *builder.failure();
    if (status != XML_STATUS_OK) {
      const InputPosition position = InputPosition::line(XML_GetCurrentLineNumber(parser.get()));
      return Error{ErrorCode::ElementMalformed, {"XML", XML_ErrorString(XML_GetErrorCode(parser.get()))}, position, {}};
    }
  }
  return builder.takeRoot();
}

Error malformed(const XmlElement& element, std::string what) {
  const std::string* name = element.attribute("name");
  return {ErrorCode::ElementMalformed,
          {name && !name->empty() ? element.name + " " + *name : element.name, std::move(what)},
          InputPosition::line(element.line),
          {}};
}

}  // namespace handwheel
