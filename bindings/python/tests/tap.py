# Runs the cases of one module of unittest's and says in TAP what became of them.
#
# usage: tap.py MODULE

import sys
import traceback
import unittest


class Taps(unittest.TestResult):
    def __init__(self):
        super().__init__()
        self.number = 0

    def say(self, good, test, more=""):
        self.number += 1
        print(f"{'ok' if good else 'not ok'} {self.number} - {test.id().split('.')[-1]}{more}", flush=True)

    def addSuccess(self, test):
        self.say(True, test)

    def addSkip(self, test, reason):
        self.say(True, test, f" # SKIP {reason}")

    def complain(self, test, error):
        print("".join(f"# {line}\n" for part in traceback.format_exception(*error) for line in part.splitlines()))
        self.say(False, test)

    def addError(self, test, error):
        super().addError(test, error)
        self.complain(test, error)

    def addFailure(self, test, error):
        super().addFailure(test, error)
        self.complain(test, error)

    def addSubTest(self, test, subtest, error):
        if error is not None:
            super().addSubTest(test, subtest, error)
            self.complain(subtest, error)


def main():
    suite = unittest.defaultTestLoader.loadTestsFromName(sys.argv[1])
    result = Taps()
    suite.run(result)
    print(f"1..{result.number}")
    return 0 if result.wasSuccessful() and result.number > 0 else 1


if __name__ == "__main__":
    sys.exit(main())
