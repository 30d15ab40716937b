"""What is told of an answer: words, tables, pictures."""
