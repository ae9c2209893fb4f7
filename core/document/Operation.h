// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Fidelity.h"
#include "document/Property.h"

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace handwheel {

// A typed, named input of an operation: the description of its values.
struct Parameter {
  // A number of a list: "x".
  struct Part {
    std::string id;
    std::string label = {};  // as that of a property
  };

  // As a tool shows it. Its id is the option on the command line and in steps: "near-weld". Its value is the default,
  // and tells the type: a bool is a flag; a number one of the choices, if there are any; a text also a list of numbers.
  Property property;
  std::string meaning;                  // English, one line, without a full stop
  std::string word = {};                // for its value in lines of syntax: "SHARE"; empty for a flag
  std::vector<std::string> words = {};  // of the choices, as they are typed: "fair"
  std::vector<Part> parts = {};         // of a list of numbers, one for each
  bool isWhole = false;                 // takes whole numbers only
  bool hasDefault = true;               // false: without a value it means something that no value says
  bool isAlwaysWritten = false;         // even if it is the default, which people may change in the window
  std::string bundle = {};              // of parameters that several operations share: "FILL" in lines of syntax
  std::string formerId = {};            // still understood, in no help

  const std::string& id() const { return property.id; }
  bool isFlag() const { return std::holds_alternative<bool>(property.value); }
};

// The parameter for a measured setting, under a short name of its own.
Parameter measuredParameter(const char* id, const FidelitySetting& setting, const char* word, std::string meaning);

// Description of a user command that changes a document: its name and its parameters. The command line, the steps of
// 'edit', the settings of tools, reports and the log are made from it (docs/adr/0022-operations.md).
struct Operation {
  std::string id;             // its verb: "decimate"
  const char* title;          // of the undo step; English, context "Tool"
  std::string meaning;        // English, one line
  std::string operands = {};  // of its step, as a help page shows them: "LOOP [PLACE...]"
  std::vector<Parameter> parameters = {};
  std::string formerId = {};  // still understood, in no help

  const Parameter* find(std::string_view parameter) const;  // by its id; null when there is none
};

// The values of the parameters of an operation. Those that were not set have their defaults. A value type. The
// operation must outlive it, and the ids given to it must be those of its parameters.
class OperationValues {
 public:
  explicit OperationValues(const Operation& operation) : m_operation(&operation) {}
  const Operation& operation() const { return *m_operation; }

  // Whether a value other than the default was set.
  bool isSet(std::string_view id) const { return m_set.contains(id); }
  // The value, or the default; none where there is neither.
  std::optional<PropertyValue> value(std::string_view id) const;

  // By type. The parameter must have a value of this type, but for given().
  bool flag(std::string_view id) const;
  double number(std::string_view id) const;
  std::size_t whole(std::string_view id) const;  // also the index of a choice
  std::string text(std::string_view id) const;
  std::vector<double> numbers(std::string_view id) const;  // mm, radian
  std::optional<double> given(std::string_view id) const;  // of a parameter without a default

  // Sets a value. Returns what is wrong with it as a clause that names the parameter, the value and the range; then
  // nothing has changed. A list of numbers is taken as its text.
  [[nodiscard]] std::string set(std::string_view id, const PropertyValue& value);
  // Sets a value that is known to be within the range.
  void setValid(std::string_view id, const PropertyValue& value);
  void setValid(std::string_view id, const std::vector<double>& numbers);
  void reset(std::string_view id);

  bool operator==(const OperationValues& other) const { return m_set == other.m_set; }

 private:
  const Parameter& parameter(std::string_view id) const;

  const Operation* m_operation;
  std::map<std::string, PropertyValue, std::less<>> m_set;  // none that equals its default
};

}  // namespace handwheel
