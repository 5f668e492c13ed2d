"""Files with labels on command lines."""
import os


def labelled(word):
    """Returns label and file of a word [LABEL=]FILE; None without a label. A sign in the name of a folder, such as
    runs/000_gamma=0.1/record.csv, does not end a label: a label has no slash, and the name of a file has no label."""
    label, sign, file = word.partition('=')
    return (None, word) if not label or not sign or '/' in label or os.path.exists(word) else (label, file)
