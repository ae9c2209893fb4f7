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
    std::string label = {};  // see Property::label
  };

  // The property that a tool shows. Its id is the option on the command line and in steps: "near-weld". Its value is
  // the default, and determines the type: a bool is a flag; a number one of the choices, if there are any; a text also
  // a list of numbers.
  Property property;
  std::string meaning;                  // English, one line, without a full stop
  std::string word = {};                // placeholder of its value in lines of syntax: "SHARE"; empty for a flag
  std::vector<std::string> words = {};  // words of the choices on the command line: "fair"
  std::vector<Part> parts = {};         // numbers of a list, one for each
  bool isWhole = false;                 // accepts whole numbers only
  bool hasDefault = true;               // false: no value has a meaning that no value expresses
  bool isAlwaysWritten = false;         // even if it is the default, which users may change in the window
  std::string bundle = {};              // group of parameters that several operations share: "FILL" in lines of syntax
  std::string formerId = {};            // still accepted, but not shown in the help

  const std::string& id() const { return property.id; }
  bool isFlag() const { return std::holds_alternative<bool>(property.value); }
};

// Returns the parameter for a measured setting, under a short name of its own.
Parameter measuredParameter(const char* id, const FidelitySetting& setting, const char* word, std::string meaning);

// Description of a user command that changes a document: its name and its parameters. The command line, the steps of
// 'edit', the settings of tools, reports and the log are made from it (docs/adr/0022-operations.md).
struct Operation {
  std::string id;             // its verb: "decimate"
  const char* title;          // title of the undo step; English, context "Tool"
  std::string meaning;        // English, one line
  std::string operands = {};  // operands of its step in the help: "LOOP [PLACE...]"
  std::vector<Parameter> parameters = {};
  std::string formerId = {};  // still accepted, but not shown in the help

  const Parameter* find(std::string_view parameter) const;  // by its id; null if there is none
};

// The values of the parameters of an operation. Unset parameters have their defaults. A value type. The operation must
// outlive it, and the ids given to it must be those of its parameters.
class OperationValues {
 public:
  explicit OperationValues(const Operation& operation) : m_operation(&operation) {}
  const Operation& operation() const { return *m_operation; }

  // Returns true if a value other than the default was set.
  bool isSet(std::string_view id) const { return m_set.contains(id); }
  // Returns the value, or the default; none if there is neither.
  std::optional<PropertyValue> value(std::string_view id) const;

  // Return the value by type. The parameter must have a value of this type, except for given().
  bool flag(std::string_view id) const;
  double number(std::string_view id) const;
  std::size_t whole(std::string_view id) const;  // also the index of a choice
  std::string text(std::string_view id) const;
  std::vector<double> numbers(std::string_view id) const;  // mm, radian
  std::optional<double> given(std::string_view id) const;  // for a parameter without a default

  // Sets a value. Returns the error as a clause that names the parameter, the value and the range; then nothing has
  // changed. A list of numbers is given as its text.
  [[nodiscard]] std::string set(std::string_view id, const PropertyValue& value);
  // Sets a value that is known to be within the range.
  void setValid(std::string_view id, const PropertyValue& value);
  void setValid(std::string_view id, const std::vector<double>& numbers);
  void reset(std::string_view id);

  bool operator==(const OperationValues& other) const { return m_set == other.m_set; }

 private:
  const Parameter& parameter(std::string_view id) const;

  const Operation* m_operation;
  std::map<std::string, PropertyValue, std::less<>> m_set;  // none equals its default
};

}  // namespace handwheel
