// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/Arguments.h"
#include "document/Operation.h"

#include <initializer_list>
#include <span>

namespace handwheel {

// Returns the options of a command for an operation, which must outlive them. without: the ids of parameters without an
// option.
std::vector<OptionSpec> optionsOf(const Operation& operation, std::initializer_list<std::string_view> without = {});

// Sets the values that are given as options; other values stay. Returns the error as a sentence, or nothing.
std::string readOptions(const Arguments& arguments, OperationValues& values);

// Turns a clause into a sentence with a capital letter and a full stop.
std::string sentenceOf(std::string clause);

// Returns the list of operations on the help page of 'edit', with their parameters.
std::string stepsHelp(std::span<const Operation> operations);

}  // namespace handwheel
