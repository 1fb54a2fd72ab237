//! Instructions of a call from the ticks that an image printed.

/// How far a quotient may be from a whole number: half a tick is an eighth of an instruction on the
/// coarsest board.
const TOLERANCE: f64 = 0.3;

/// What an image said of an operation.
#[derive(Debug, PartialEq)]
pub(crate) struct Counted {
    pub(crate) law: String,
    pub(crate) operation: String,
    /// Where the function begins.
    pub(crate) address: u64,
    /// Words of 32 bits that it draws.
    pub(crate) words: u64,
    /// Bytes of stack, the deepest of all inputs.
    pub(crate) stack: u64,
    /// Instructions of each input's call.
    pub(crate) instructions: Vec<u64>,
}

impl Counted {
    pub(crate) fn least(&self) -> u64 {
        self.instructions.iter().copied().min().unwrap_or(0)
    }

    pub(crate) fn mean(&self) -> f64 {
        let sum: u64 = self.instructions.iter().sum();
        sum as f64 / self.instructions.len().max(1) as f64
    }

    pub(crate) fn most(&self) -> u64 {
        self.instructions.iter().copied().max().unwrap_or(0)
    }
}

/// How ticks become instructions.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Scale {
    instructions_in_tick: f64,
    repeats: f64,
}

impl Scale {
    /// Instructions of one of the repeated calls: a whole number, or no figure.
    fn instructions(self, ticks: u64) -> Result<u64, String> {
        // Ticks are counted from the edge of one: what follows the last is half a tick in the mean.
        // Where a tick is an instruction nothing follows it.
        let follows = if self.instructions_in_tick > 1.0 {
            0.5
        } else {
            0.0
        };
        let exact = (ticks as f64 + follows) * self.instructions_in_tick / self.repeats;
        let whole = exact.round();
        if (exact - whole).abs() > TOLERANCE {
            return Err(format!(
                "{ticks} ticks are {exact:.3} instructions a call; expected a whole number"
            ));
        }
        Ok(whole as u64)
    }
}

/// The operations that an image printed, whole.
pub(crate) fn parse(text: &str) -> Result<Vec<Counted>, String> {
    let mut lines = text.lines().enumerate();
    let (_, head) = lines.next().ok_or("no output; expected a line `count …`")?;
    let scale = scale(head).ok_or_else(|| {
        format!("line 1: {head:?}; expected `count INSTRUCTIONS_IN_TWO_TICKS REPEATS`")
    })?;
    let mut all = Vec::new();
    for (i, line) in lines {
        if line == "done" {
            return Ok(all);
        }
        let counted = operation(line, scale).map_err(|e| format!("line {}: {e}", i + 1))?;
        all.push(counted);
    }
    let last = text.lines().last().unwrap_or_default();
    Err(format!(
        "the output ends early, after {} operations with {last:?}; expected a line `done`",
        all.len()
    ))
}

fn scale(line: &str) -> Option<Scale> {
    let mut numbers = line
        .strip_prefix("count ")?
        .split(' ')
        .map(str::parse::<f64>);
    let (two, repeats) = (numbers.next()?.ok()?, numbers.next()?.ok()?);
    Some(Scale {
        instructions_in_tick: two / 2.0,
        repeats,
    })
}

fn operation(line: &str, scale: Scale) -> Result<Counted, String> {
    let fields: Vec<&str> = line.split(' ').collect();
    let [law, operation, address, words, stack, base, ticks] = fields[..] else {
        return Err(format!(
            "{line:?}; expected LAW OPERATION ADDRESS WORDS STACK,BASE BASE_TICKS TICKS,…"
        ));
    };
    let number = |text: &str| {
        text.parse::<u64>()
            .map_err(|_| format!("{text:?}; expected a number"))
    };
    let address = address
        .strip_prefix("0x")
        .and_then(|hex| u64::from_str_radix(hex, 16).ok())
        .ok_or_else(|| format!("{address:?}; expected an address"))?;
    let (own, empty) = stack
        .split_once(',')
        .ok_or_else(|| format!("{stack:?}; expected STACK,BASE"))?;
    let base = scale.instructions(number(base)?)?;
    let less = |a: u64, b: u64, what| {
        a.checked_sub(b)
            .ok_or_else(|| format!("{what}: {a}, less than the empty call's {b}"))
    };
    let instructions = ticks
        .split(',')
        .map(|t| less(scale.instructions(number(t)?)?, base, "instructions"))
        .collect::<Result<Vec<_>, _>>()?;
    Ok(Counted {
        law: law.to_owned(),
        operation: operation.to_owned(),
        address,
        words: number(words)?,
        stack: less(number(own)?, number(empty)?, "bytes of stack")?,
        instructions,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const M0: &str = "count 125 256\nBall pdf 0x1db4 2 220,24 82 8192,8200\ndone\n";

    #[test]
    fn ticks_become_instructions_less_those_of_an_empty_call() {
        let all = parse(M0).unwrap();
        // 82.5 · 62.5 / 256 = 20.1; 8192.5 · 62.5 / 256 = 2000.1; 8200.5 · 62.5 / 256 = 2002.1.
        assert_eq!(all[0].instructions, [1980, 1982]);
        assert_eq!(
            (all[0].least(), all[0].mean(), all[0].most()),
            (1980, 1981.0, 1982)
        );
        assert_eq!(
            (all[0].address, all[0].words, all[0].stack),
            (0x1db4, 2, 196)
        );
    }

    #[test]
    fn riscv_counts_instructions_themselves() {
        let all = parse("count 2 256\nBall pdf 0x80000000 0 8,8 3076 3332\ndone\n").unwrap();
        assert_eq!(all[0].instructions, [1]);
    }

    /// Half a tick that was forgotten, a count without its loop, an output cut short: each is seen.
    #[test]
    fn planted_mistakes_are_caught() {
        let broken = |from: &str, to: &str| parse(&M0.replacen(from, to, 1)).unwrap_err();
        assert!(broken("8192", "8190").contains("expected a whole number"));
        assert!(broken("8192", "40").contains("less than the empty call's 20"));
        assert!(broken("done\n", "").contains("ends early"));
        assert!(broken("220,24", "24,220").contains("bytes of stack"));
        assert!(broken("220,24", "220").contains("line 2: \"220\"; expected STACK,BASE"));
        assert!(broken("count 125", "count").contains("line 1"));
        assert!(broken("8200", "82OO").contains("expected a number"));
        assert!(broken(" pdf", "").contains("expected LAW OPERATION"));
        assert!(parse("").unwrap_err().contains("no output"));
    }
}
