// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "controls/program/ProgramWords.h"

#include <QString>

namespace handwheel {

namespace {

using Kind = EditorWord::Kind;

constexpr QStringView kSigns = u"[]+-*/=,%&|!<>:^";
constexpr QStringView kAxes = u"XYZABCUVWIJKREPQL";
constexpr QStringView kMachine = u"MTSFDH";

bool isFigure(QChar c) {
  return c >= u'0' && c <= u'9';
}

bool isLetter(QChar c) {
  return (c >= u'A' && c <= u'Z') || (c >= u'a' && c <= u'z');
}

class ProgramScanner {
 public:
  explicit ProgramScanner(QStringView line) : m_line(line) {}

  std::vector<EditorWord> words() {
    while (m_at < m_line.size()) next();
    return std::move(m_words);
  }

 private:
  QChar here() const { return m_at < m_line.size() ? m_line[m_at] : QChar(); }

  void add(qsizetype start, Kind kind) {
    m_words.push_back({static_cast<int>(start), static_cast<int>(m_at - start), kind});
  }

  void next() {
    const QChar c = here();
    const qsizetype start = m_at;
    if (c == u';') {
      m_at = m_line.size();
      return add(start, Kind::Comment);
    }
    if (c == u'(') {
      const qsizetype end = m_line.indexOf(u')', m_at);
      m_at = end < 0 ? m_line.size() : end + 1;
      return add(start, Kind::Comment);
    }
    if (c == u'#') return variable();
    if (isFigure(c) || c == u'.') {
      number();
      return add(start, Kind::Number);
    }
    if (isLetter(c)) return letters();
    ++m_at;
    if (!c.isSpace() && !kSigns.contains(c)) add(start, Kind::Unknown);
  }

  // Scans #1, #<name>, and ##1: the variable whose number another one holds.
  void variable() {
    const qsizetype start = m_at;
    while (here() == u'#') ++m_at;
    if (!angleBrackets()) figures();
    add(start, Kind::Variable);
  }

  bool angleBrackets() {
    if (here() != u'<') return false;
    const qsizetype end = m_line.indexOf(u'>', m_at);
    m_at = end < 0 ? m_line.size() : end + 1;
    return true;
  }

  void figures() {
    while (isFigure(here())) ++m_at;
  }

  // Scans a number with its sign, if digits follow; blanks may stand between.
  void number() {
    const qsizetype start = m_at;
    while (here() == u' ') ++m_at;
    if (here() == u'+' || here() == u'-') ++m_at;
    const qsizetype digits = m_at;
    while (isFigure(here()) || here() == u'.') ++m_at;
    if (m_at == digits) m_at = start;
  }

  // Scans letters. One letter is the address of a word; two and more in a row are a word of the language.
  void letters() {
    const qsizetype start = m_at;
    while (isLetter(here())) ++m_at;
    if (m_at - start > 1) return add(start, Kind::Keyword);
    const QChar letter = m_line[start].toUpper();
    if (letter == u'O' && angleBrackets()) return add(start, Kind::Subprogram);
    const bool isAxis = kAxes.contains(letter);
    if (isAxis) add(start, Kind::Axis);
    const qsizetype value = m_at;
    number();
    if (!isAxis) return add(start, kindOf(letter));
    if (m_at > value) add(value, Kind::Number);
  }

  static Kind kindOf(QChar letter) {
    if (letter == u'G') return Kind::Preparatory;
    if (letter == u'N') return Kind::LineNumber;
    if (letter == u'O') return Kind::Subprogram;
    return kMachine.contains(letter) ? Kind::Machine : Kind::Unknown;
  }

  QStringView m_line;
  qsizetype m_at = 0;
  std::vector<EditorWord> m_words;
};

}  // namespace

std::vector<EditorWord> programWords(QStringView line) {
  return ProgramScanner(line).words();
}

}  // namespace handwheel
