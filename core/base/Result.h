// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/Error.h"

#include <cassert>
#include <utility>
#include <variant>

namespace handwheel {

// Either a value or an error. It reports failures of files, devices and input; bugs are asserted instead. It is
// modelled on std::expected, which clang 14 does not have.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : m_content(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : m_content(std::in_place_index<1>, std::move(error)) {}

  bool hasValue() const { return m_content.index() == 0; }
  explicit operator bool() const { return hasValue(); }

  T& value() & { return std::get<0>(m_content); }
  const T& value() const& { return std::get<0>(m_content); }
  T&& value() && { return std::get<0>(std::move(m_content)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  const Error& error() const { return std::get<1>(m_content); }

 private:
  std::variant<T, Error> m_content;
};

// The empty value of a successful Status.
struct Done {};
using Status = Result<Done>;

}  // namespace handwheel
