// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "TestClass.h"

#include <chrono>
#include <cstdio>
#include <map>
#include <string>
#include <thread>

namespace {

std::map<std::string, handwheel::test::TestClass::Run>& classes() {
  static std::map<std::string, handwheel::test::TestClass::Run> all;
  return all;
}

}  // namespace

handwheel::test::TestClass::TestClass(const char* name, Run run) {
  classes()[name] = run;
}

int main(int argc, char** argv) {
  const auto named = argc > 1 ? classes().find(argv[1]) : classes().end();
  if (named != classes().end()) {
    const int failures = named->second(argc - 1, argv + 1);
#ifdef __SANITIZE_ADDRESS__
    // The thread with which QtTest watches the time frees its data shortly after Qt has waited for it; leaks are looked
    // for at once.
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
#endif
    return failures;
  }
  std::fprintf(stderr, "usage: %s CLASS [OPTIONS AND FUNCTIONS OF QT TEST]\n", argv[0]);
  for (const auto& [name, run] : classes()) std::fprintf(stderr, "  %s\n", name.c_str());
  return 1;
}
