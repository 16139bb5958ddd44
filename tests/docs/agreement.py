"""What the tests of the documents' readers share."""
import math, random, subprocess, sys


def fail(problem):
    sys.exit(f"failed: {problem}")


def pairs_above_the_horizon(count):
    """Lines of k1 and k2, the same ones each time; a third of the pairs mirror one another about a normal near z."""
    random.seed(1)
    lines = []
    for index in range(count):
        k = []
        for _ in range(2):
            z, azimuth = random.uniform(0.02, 1), random.uniform(0, 2 * math.pi)
            k += [math.sqrt(1 - z * z) * math.cos(azimuth), math.sqrt(1 - z * z) * math.sin(azimuth), z]
        if index % 3 == 0:
            k[3:] = [-k[0], -k[1], k[2] + 0.05]
        lines.append(" ".join(f"{value:.9g}" for value in k))
    return lines


def rows_of(command, lines):
    """The numbers that a program prints for lines of input: a row a line."""
    done = subprocess.run(command, input="\n".join(lines) + "\n", capture_output=True, text=True)
    if done.returncode != 0:
        fail(f"{command}: {done.stderr}")
    rows = [[float(word) for word in line.split()] for line in done.stdout.splitlines()]
    if len(rows) != len(lines):
        fail(f"{command}: {len(rows)} rows for {len(lines)} lines")
    return rows


def require_close(what, got, expected, tolerance):
    """The largest |got - expected|/max(1, |expected|), which must not exceed the tolerance."""
    worst = max(abs(a - b) / max(1, abs(b)) for x, y in zip(got, expected, strict=True) for a, b in zip(x, y, strict=True))
    print(f"{what}: largest difference {worst:.2g}, at most {tolerance:g}")
    if not worst <= tolerance:
        fail(what)
