# zsh -f complete.zsh FOLDER LINE: what zsh with the completions in FOLDER offers behind LINE, one a line.
# A shell on a terminal of its own completes the line; what its functions add is printed between < and >.
zmodload zsh/zpty
zpty shell zsh -f -i
zpty -w shell "PS1=; PS2=; unsetopt prompt_cr prompt_sp; fpath=(${(q)1} \$fpath); autoload -Uz compinit; compinit -D -u"
zpty -w shell 'compadd() { builtin compadd -O matches "$@"; print -rl -- "<"${^matches}">"; builtin compadd "$@" }'
zpty -w shell 'LISTMAX=10000; bindkey ^I list-choices; _finish() { print "<>" }; zle -N _finish; bindkey ^X _finish; print REA""DY'
zpty -r shell output '*READY*'
zpty -w -n shell "$2"$'\t\x18'
zpty -r shell output '*<>*'
print -r -- $output | tr -d '\r' | grep -o '<[^<>]\+>' | tr -d '<>' | sort -u
zpty -d shell
