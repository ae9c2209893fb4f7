// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "machining/program/ProgramBlock.h"

#include "base/NumberText.h"

namespace handwheel {

namespace {

constexpr double kLargest = 1e9;  // limit of any number in a word

struct Assignment : ProgramAssignment {
  std::string name;  // empty: the variable has a number
};

Assignment readAssignment(ProgramScanner& scanner, const ProgramVariables& variables, ProgramDialect dialect) {
  Assignment set;
  set.location = scanner.location();
  scanner.take();  // #
  ProgramExpression expression(scanner, variables, dialect);
  if (scanner.peek() == '<')
    set.name = scanner.name();
  else
    set.number = expression.variableNumber();
  scanner.expect('=', "Write #number=value.");
  const std::size_t behind = scanner.at();
  set.value = dialect == ProgramDialect::Fanuc ? expression.expression() : expression.value();
  set.comment = scanner.commentFrom(behind);
  if (set.number == 0 && set.name.empty())
    refuse(set.location, "#0", "this variable is always vacant", "Use another number.");
  return set;
}

ProgramWord readWord(ProgramScanner& scanner, const ProgramVariables& variables, ProgramDialect dialect,
                     bool& isVacant) {
  ProgramWord word;
  word.location = scanner.location();
  const bool isCorner = dialect == ProgramDialect::Fanuc && scanner.takeIf(',');
  word.letter = scanner.peek();
  if (isCorner) {
    if (word.letter != 'C' && word.letter != 'R')
      refuse(word.location, "," + scanner.token(), "only ,C and ,R follow a comma", "Write the end of the move.");
    word.letter = word.letter == 'C' ? 'c' : 'r';
  } else if (!scanner.nextIsLetter())
    refuse(word.location, scanner.token(), "no word begins with this", "Remove it, or put it in a comment.");
  scanner.take();
  const std::size_t begin = scanner.at();
  const std::string digits = scanner.token();
  const ProgramValue value = ProgramExpression(scanner, variables, dialect).value();
  word.number = value.number;
  isVacant = value.isVacant;
  const bool isPlain = !digits.empty() && (isDigit(digits[0]) || digits[0] == '-' || digits[0] == '+');
  word.hasPoint = !isPlain || digits.find('.') != std::string::npos || scanner.at() == begin;
  if (!(std::abs(word.number) <= kLargest))
    refuse(word.location, word.text(), "the number is too large",
           "Numbers may have up to nine digits before the point.");
  return word;
}

}  // namespace

std::string ProgramWord::text() const {
  return (letter == 'c' ? ",C" : letter == 'r' ? ",R" : std::string(1, letter)) + roundedText(number);
}

const ProgramWord* ProgramBlock::find(char letter) const {
  for (const ProgramWord& word : words)
    if (word.letter == letter) return &word;
  return nullptr;
}

double ProgramBlock::number(char letter, double otherwise) const {
  const ProgramWord* const word = find(letter);
  return word ? word->number : otherwise;
}

bool skipsRest(ProgramScanner& scanner, const ProgramSetup& setup) {
  const bool isFanuc = setup.dialect == ProgramDialect::Fanuc;
  while (const int number = scanner.takeSkip(isFanuc)) {
    if (setup.skips >> number & 1) return true;
    if (!isFanuc) break;
  }
  return false;
}

ProgramBlock readBlock(ProgramScanner& scanner, ProgramVariables& variables, const ProgramSetup& setup) {
  const ProgramDialect dialect = setup.dialect;
  ProgramBlock block;
  block.location = scanner.location();
  std::vector<Assignment> assignments;
  while (scanner.peek() != '\0') {
    if (dialect == ProgramDialect::Fanuc && scanner.peek() == '/') {  // within a line it skips the rest
      if (skipsRest(scanner, setup)) break;
      continue;
    }
    if (scanner.peek() == '#') {
      assignments.push_back(readAssignment(scanner, variables, dialect));
      continue;
    }
    if (block.words.size() >= ProgramBlock::kMostWords)
      refuse(scanner.location(), scanner.token(), "the line has too many words", "Divide it over several lines.");
    bool isVacant = false;
    const ProgramWord word = readWord(scanner, variables, dialect, isVacant);
    if (word.letter == 'N') block.sequence = word.number;
    if (isVacant || word.letter == 'N') continue;
    if (word.letter != 'G' && word.letter != 'M' && block.has(word.letter))
      refuse(word.location, word.text(), "this letter occurs twice in the line", "Remove one of them.");
    block.words.push_back(word);
  }
  for (const Assignment& set : assignments) {
    if (set.name.empty())
      variables.set(set);
    else
      variables.set(set.name, set.value.number, set.location);
  }
  return block;
}

}  // namespace handwheel
