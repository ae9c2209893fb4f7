// SPDX-FileCopyrightText: 2026 The Handwheel developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QtTest>

// Macros that combine the test classes of a folder into one program. It is linked only once, and runs the class that is
// named on its command line. A source file ends with HANDWHEEL_TEST(Class) or with another macro that uses
// HANDWHEEL_TEST_RUN.
namespace handwheel::test {

// Registers a test class. `run` is used as main() if the program has no other class.
struct TestClass {
  using Run = int (*)(int argc, char** argv);
  TestClass(const char* name, Run run);
};

template <class Application, class Test>
int runTest(int argc, char** argv) {
  Application application(argc, argv);
  QCoreApplication::setAttribute(Qt::AA_Use96Dpi);
  Test test;
  return QTest::qExec(&test, argc, argv);
}

}  // namespace handwheel::test

#define HANDWHEEL_TEST_RUN(Test, ...) static const handwheel::test::TestClass registered##Test(#Test, __VA_ARGS__);
#define HANDWHEEL_TEST(Test) HANDWHEEL_TEST_RUN(Test, handwheel::test::runTest<QCoreApplication, Test>)
// Registers a test class that needs a QApplication. The programs of the core use only QCoreApplication.
#define HANDWHEEL_WIDGET_TEST(Test) HANDWHEEL_TEST_RUN(Test, handwheel::test::runTest<QApplication, Test>)
