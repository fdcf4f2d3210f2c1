"""What a log of rbcIbFoam says."""
import re

NUMBER = r"([-+.\deE]+)"


class Log:
    """The log of a case; that of a continued run has several runs."""

    def __init__(self, path):
        with open(path, errors="replace") as file:
            self.text = file.read()
        self.runs = re.split(r"^Create time$", self.text, flags=re.M)[1:] or [self.text]
        self.quiet = not re.search(r"^Time = ", self.text, re.M) \
            and bool(re.search(rf"^Time {NUMBER} of ", self.text, re.M))
        self.ended = bool(re.search(r"^End", self.runs[-1], re.M))
        self.last = self.one(rf"^Time (?:= )?{NUMBER}(?: of .*)?$")
        error = re.search(r"^--> FOAM FATAL.*?(?=\n\n *From|\n *FOAM |\Z)", self.text, re.M | re.S)
        self.error = error.group(0).strip() if error else ""

    def one(self, pattern):
        found = re.findall(pattern, self.text, re.M)
        return found[-1] if found else None

    def end(self):
        """A sentence on how the run ended."""
        signal = re.search(r"^--> Signal (\d+) received", self.runs[-1], re.M)
        ended = f"was ended by signal {signal.group(1)}" if signal \
            else "ran to its end" if self.ended else "has not reached its end"
        return f"The run {ended}; its last step is that to {self.last or 'none'} s."

    def lines(self, *patterns):
        return [text for text in map(self.one, patterns) if text]

    def programs(self):
        return self.lines(r"^(deformableParticles .*)$", r"^Build +: (.*)$", r"^(nProcs +: .*)$")

    def clumps(self):
        """Lines on what was there at the start and at the end."""
        return self.lines(r"^((?:Placed|Read) \d+ clumps.*)$",
                          r"^(Haematocrit 0?\.\d*[1-9].*)$",
                          r"^(Clumps: \d+ inside, \d+ entered, \d+ left)$")

    def passages(self):
        """(type, entered or left, patch) of every clump that has entered or left."""
        return re.findall(r"^Clump \d+ \((.+)\) has (entered|left) through patch (\S+)", self.text,
                          re.M)

    def lines_after(self, title):
        """The indented lines below a title, of the last run."""
        found = re.search(rf"^{title}.*\n((?: +.*\n)+)", self.runs[-1], re.M)
        return found.group(1).rstrip().split("\n") if found else []

    def seconds(self):
        """Processor time of all runs in the log, and their steps."""
        runs = [re.findall(rf"^ExecutionTime = {NUMBER} s", run, re.M) for run in self.runs]
        return sum(float(run[-1]) for run in runs if run), sum(len(run) for run in runs)

    def warnings(self):
        """Texts of the warnings of the last run, each once."""
        found = re.findall(r"^--> FOAM (?:IO)?Warning.*\n((?: +.*\n)+)", self.runs[-1], re.M)
        texts = [re.sub(r"^ +(?:From|in file) .*\n", "", text, flags=re.M) for text in found]
        return list(dict.fromkeys(" ".join(text.split()) for text in texts))

    def changes(self):
        """Effects that were switched on or off during the run, with the time."""
        found, time = [], ""
        for line in self.text.split("\n"):
            if line.startswith("Time = "):
                time = line[7:] + " s: "
            elif re.match(r"Effect \w+: now ", line):
                found.append(time + line)
        return found

    def per_step(self, pattern):
        """Times and the last number of a step that the pattern finds, for every step with one."""
        times, values = [], []
        for part in re.split(r"^Time = ", self.text, flags=re.M)[1:]:
            found = re.findall(pattern, part, re.M)
            if found:
                times.append(float(part.split("\n", 1)[0]))
                values.append(float(found[-1]))
        return times, values
