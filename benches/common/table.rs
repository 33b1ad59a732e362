//! Markdown tables with aligned columns, for the terminal and for `docs/performance.md`.

/// A table with a heading. The first column is text, the others are numbers.
pub(crate) struct Table {
    title: String,
    columns: Vec<String>,
    rows: Vec<Vec<String>>,
    note: Option<String>,
}

impl Table {
    /// A table without rows.
    pub(crate) fn new(title: &str, columns: &[&str]) -> Self {
        let columns = columns.iter().map(|&column| column.to_owned()).collect();
        Table { title: title.to_owned(), columns, rows: Vec::new(), note: None }
    }

    /// Adds a row. Missing cells at its end stay empty.
    pub(crate) fn row(&mut self, name: &str, cells: &[String]) {
        let mut row = vec![name.to_owned()];
        row.extend_from_slice(cells);
        row.resize(self.columns.len(), String::new());
        self.rows.push(row);
    }

    /// Adds a sentence below the heading.
    pub(crate) fn note(&mut self, note: &str) {
        self.note = Some(note.to_owned());
    }

    /// Writes the table to standard output. A table without rows is printed as its note, or not at all.
    pub(crate) fn print(&self) {
        if self.rows.is_empty() {
            return self.note.iter().for_each(|note| println!("\n## {}\n\n{note}", self.title));
        }
        let width = |column: usize| {
            let cells = self.rows.iter().map(|row| row[column].chars().count());
            cells.chain([self.columns[column].chars().count()]).max().unwrap_or(0)
        };
        let widths: Vec<usize> = (0..self.columns.len()).map(width).collect();
        let line = |cells: &[String]| {
            let cells = cells.iter().zip(&widths).enumerate().map(|(column, (cell, &width))| match column {
                0 => format!("{cell:<width$}"),
                _ => format!("{cell:>width$}"),
            });
            format!("| {} |", cells.collect::<Vec<_>>().join(" | "))
        };
        let rule = widths.iter().enumerate().map(|(column, &width)| match column {
            0 => "-".repeat(width + 2),
            _ => format!("{}:", "-".repeat(width + 1)),
        });
        println!("\n## {}\n", self.title);
        if let Some(note) = &self.note {
            println!("{note}\n");
        }
        println!("{}\n|{}|", line(&self.columns), rule.collect::<Vec<_>>().join("|"));
        self.rows.iter().for_each(|row| println!("{}", line(row)));
    }
}

/// A cell with `digits` decimal digits.
pub(crate) fn number(value: f64, digits: usize) -> String {
    format!("{value:.digits$}")
}
