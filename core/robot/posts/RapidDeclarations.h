// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robot/posts/RapidStatements.h"
#include "robot/program/RobotProgram.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace handwheel {

// A name in RAPID, in lower case, and the number of its scope.
using RapidName = std::pair<std::size_t, std::string>;

// The declarations of RAPID modules. As the statements of all routines become one sequence, a declaration that has the
// name of another one in a different scope gets a name of its own.
class RapidDeclarations {
 public:
  void setScopes(std::vector<RapidScope> scopes) { m_scopes = std::move(scopes); }
  // Adds a declaration. isNeeded: it is kept whether a kept line names it or not. Returns its name.
  RapidName add(const RapidData& data, bool isNeeded);
  // Returns the name that a statement in this scope means by `name`: that of the innermost declaration. Names that the
  // modules do not declare belong to the controller.
  RapidName resolved(std::size_t scope, const std::string& name) const;
  // Returns a text of a kept line in this scope with the names that declarations have outside of their scopes, which
  // are needed from now on.
  std::string flattened(std::size_t scope, std::string_view text);
  // Returns the needed declarations as lines.
  std::vector<ProgramLine> needed();

 private:
  struct Declaration {
    RapidData data;
    RapidName name;
    std::string newName;  // empty: it keeps its name
    bool isNeeded = false;
  };
  std::vector<RapidScope> m_scopes;
  std::vector<Declaration> m_all;
  std::map<RapidName, std::size_t> m_numbers;  // in m_all
  std::set<std::string> m_taken;               // names in lower case
};

// Data of one type by their names; none: declared, and unusable.
template <class Value>
class RapidTable {
 public:
  // A name that two declarations give different values is unusable.
  void add(const RapidName& name, std::optional<Value> value) {
    const auto [known, isNew] = m_values.emplace(name, value);
    if (!isNew && !(known->second && value && isSame(*known->second, *value))) known->second = std::nullopt;
  }
  // Returns the value; nothing if there is none of this name, or it is unusable.
  std::optional<Value> find(const RapidName& name) const {
    const auto found = m_values.find(name);
    return found == m_values.end() ? std::nullopt : found->second;
  }
  bool contains(const RapidName& name) const { return m_values.contains(name); }

 private:
  static bool isSame(const Value& a, const Value& b) {
    if constexpr (requires { a.matrix(); })
      return a.matrix() == b.matrix();
    else
      return a == b;
  }

  std::map<RapidName, std::optional<Value>> m_values;
};

}  // namespace handwheel
