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

// A parameter of an operation: its name, its type and the range of its values.
struct Parameter {
  // The description of one number of a list.
  struct Part {
    std::string id;
    std::string label = {};  // see Property::label
  };

  // The property that a tool shows. Its id is the option on the command line and in steps: "near-weld". Its value is
  // the default and determines the type: a bool is a flag, a number is the index of a choice if there are choices, and
  // a text may also be a list of numbers.
  Property property;
  std::string meaning;                  // explanation in English, one line, without a full stop
  std::string word = {};                // placeholder of the value in lines of syntax: "SHARE"; empty for a flag
  std::vector<std::string> words = {};  // words of the choices on the command line: "fair"
  std::vector<Part> parts = {};         // descriptions of the numbers, for a list
  bool isWhole = false;                 // accepts whole numbers only
  bool hasDefault = true;               // false: the parameter may have no value
  bool isAlwaysWritten = false;         // written even if it is the default, which users may change in the window
  std::string bundle = {};              // group of parameters that several operations share: "FILL" in lines of syntax
  std::string formerId = {};            // an earlier id, accepted but not shown in the help

  const std::string& id() const { return property.id; }
  bool isFlag() const { return std::holds_alternative<bool>(property.value); }
};

// Returns the parameter for a measured setting. id: a short name for it. word: see Parameter::word.
Parameter measuredParameter(const char* id, const FidelitySetting& setting, const char* word, std::string meaning);

// Description of a user command that changes a document: its name and its parameters. It is used by the command line,
// the steps of 'edit', the settings of tools, reports and the log (docs/adr/0022-operations.md).
struct Operation {
  std::string id;             // a verb: "decimate"
  const char* title;          // title of the undo step; English, context "Tool"
  std::string meaning;        // English, one line
  std::string operands = {};  // operands of the step in the help
  std::vector<Parameter> parameters = {};
  std::string formerId = {};  // an earlier id, accepted but not shown in the help

  const Parameter* find(std::string_view parameter) const;  // by its id; null if unknown
};

// The values of the parameters of an operation. Unset parameters have their defaults. The operation must outlive this
// object, and the ids given to its functions must be those of the operation's parameters.
class OperationValues {
 public:
  explicit OperationValues(const Operation& operation) : m_operation(&operation) {}
  const Operation& operation() const { return *m_operation; }

  // Returns true if a value other than the default was set.
  bool isSet(std::string_view id) const { return m_set.contains(id); }
  // Returns the value, or the default; nothing if the parameter has no value and no default.
  std::optional<PropertyValue> value(std::string_view id) const;

  // Return the value of a parameter, which must be of the type of the function. The parameter must have a value, except
  // for given().
  bool flag(std::string_view id) const;
  double number(std::string_view id) const;
  std::size_t whole(std::string_view id) const;  // also the index of a choice
  std::string text(std::string_view id) const;
  std::vector<double> numbers(std::string_view id) const;  // mm, rad
  std::optional<double> given(std::string_view id) const;  // for a parameter without a default

  // Sets a value; a list of numbers is given as text. Returns an empty text, or the error as a clause that names the
  // parameter, the value and the range; after an error nothing has changed.
  [[nodiscard]] std::string set(std::string_view id, const PropertyValue& value);
  // Sets a value that is known to be within the range.
  void setValid(std::string_view id, const PropertyValue& value);
  void setValid(std::string_view id, const std::vector<double>& numbers);
  void reset(std::string_view id);

  bool operator==(const OperationValues& other) const { return m_set == other.m_set; }

 private:
  const Parameter& parameter(std::string_view id) const;

  const Operation* m_operation;
  std::map<std::string, PropertyValue, std::less<>> m_set;  // only values other than the default
};

}  // namespace handwheel
